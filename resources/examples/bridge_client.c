/* SPDX-License-Identifier: GPL-3.0-or-later
 * A hand for Glenoid Studio by its bridge: put what a maker's SDK says of its device into readDevice() and what it wants for a force
 * into showForce(). Protocol: simcore/device/README.md. Little-endian machines.
 *   cc -O2 -o bridge_client bridge_client.c -lm && ./bridge_client [PORT [SECONDS]]
 *   glenoid run builtin:arthroscopy --realtime --seconds 60 --device bridge */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

struct Pose {            /* 80 bytes without gaps */
  char magic[4];         /* "GBP1" */
  uint32_t sequence;     /* one more each time */
  double position[3];    /* m: X to the right, Y up, Z toward whoever holds it */
  double quaternion[4];  /* w, x, y, z, of length 1 */
  double grip;           /* 0 open ... 1 shut */
  uint32_t buttons, reserved;
};

struct Force {           /* 64 bytes without gaps */
  char magic[4];         /* "GBF1" */
  uint32_t sequence;     /* of the pose that it answers */
  double force[3];       /* N, on the hand */
  double torque[3];      /* N m */
  uint32_t flags;        /* 1: something is felt */
  uint32_t reserved;
};

/* Your device: where it is. Here a hand that goes 20 mm to and fro once in two seconds. */
static void readDevice(double seconds, struct Pose* pose) {
  pose->position[0] = 0;
  pose->position[1] = 0;
  pose->position[2] = -0.01 * (1 - cos(3.14159265 * seconds));
  pose->quaternion[0] = 1;
  pose->quaternion[1] = pose->quaternion[2] = pose->quaternion[3] = 0;
  pose->grip = 0;
  pose->buttons = 0;
}

/* Your device: what it is to show. Call it with zero where no answer came for 5 ms. */
static void showForce(const double force[3]) { (void)force; }

int main(int argc, char** argv) {
  const int port = argc > 1 ? atoi(argv[1]) : 9310;
  const double length = argc > 2 ? atof(argv[2]) : 60;
  const double none[3] = {0, 0, 0};
  struct sockaddr_in there = {0};
  struct timespec start, now, due;
  struct Pose pose = {{'G', 'B', 'P', '1'}, 0, {0}, {0}, 0, 0, 0};
  long answers = 0, silent = 0;
  double most = 0;
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  there.sin_family = AF_INET;
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  there.sin_port = htons((uint16_t)port);
  if (handle < 0 || connect(handle, (struct sockaddr*)&there, sizeof there) != 0) return perror("socket"), 1;
  clock_gettime(CLOCK_MONOTONIC, &start);
  due = start;
  for (;;) {
    struct Force force;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const double seconds = (double)(now.tv_sec - start.tv_sec) + 1e-9 * (double)(now.tv_nsec - start.tv_nsec);
    if (seconds > length) break;
    readDevice(seconds, &pose);
    ++pose.sequence;
    if (send(handle, &pose, sizeof pose, 0) < 0 && errno != ECONNREFUSED) return perror("send"), 1;
    int heard = 0;
    while (recv(handle, &force, sizeof force, MSG_DONTWAIT) == (ssize_t)sizeof force && memcmp(force.magic, "GBF1", 4) == 0) heard = 1;
    silent = heard ? 0 : silent + 1;
    answers += heard;
    if (heard) {
      const double size = sqrt(force.force[0] * force.force[0] + force.force[1] * force.force[1] + force.force[2] * force.force[2]);
      if (size > most) most = size;
      showForce(force.force);
    } else if (silent > 5) {
      showForce(none);
    }
    due.tv_nsec += 1000000; /* a thousand times a second */
    if (due.tv_nsec >= 1000000000) due.tv_nsec -= 1000000000, ++due.tv_sec;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL);
  }
  printf("%lu poses sent, %ld answers, %.3f N at most\n", (unsigned long)pose.sequence, answers, most);
  return close(handle);
}
