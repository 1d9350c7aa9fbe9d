// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ImportWorker.h"

int main(int argc, char** argv) { return glenoid::importWorkerMain(argc, argv); }
