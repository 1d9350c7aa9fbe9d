#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1 (Debian 12): of one vtkImageData with a Direction, three kinds of filter make the same surface in three places.
#
# vtkMarchingCubes, vtkFlyingEdges3D, vtkDiscreteMarchingCubes and vtkClipVolume turn it with the Direction. vtkContourFilter,
# which hands an image to vtkSynchronizedTemplates3D, puts it where it would be with no Direction. vtkTableBasedClipDataSet
# does a third thing: it keeps the axes unturned and starts them at the low corner of the turned image's bounds. Nothing is said.
# Also, the five imaging filters tried (smooth, cast, reslice, resample, threshold) hand on an image whose Direction is gone,
# so that one smoothing step before vtkFlyingEdges3D moves the bone back.
#
# Guess before trying: all contour filters turn it, at most vtkMarchingCubes, the oldest, does not; and vtkImageReslice, made
# for oblique images, keeps the Direction. The clip filter's third place was not thought of.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
vtk=9.1.0+really9.1.0+dfsg2-5+deb12u1
tbb=2021.8.0-2+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-vtk9=$vtk" "libvtk9.1=$vtk" "libtbb12=$tbb" >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done

cat >places.py <<'CODE'
import math
import sys
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkFlyingEdges3D, vtkMarchingCubes, vtkSynchronizedTemplates3D
from vtkmodules.vtkFiltersGeneral import vtkClipVolume, vtkDiscreteMarchingCubes, vtkTableBasedClipDataSet
from vtkmodules.vtkImagingCore import vtkImageCast, vtkImageResample, vtkImageReslice, vtkImageThreshold
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth

# A ball of radius 7 about a voxel of an image turned by 30 degrees about z.
size, origin, middle, radius = (32, 28, 24), (10.0, -5.0, 3.0), (18, 12, 11), 7.0
c, s = math.cos(math.radians(30)), math.sin(math.radians(30))


def image(label=False):
    made = vtkImageData()
    made.SetDimensions(*size)
    made.SetOrigin(*origin)
    made.SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1)
    made.AllocateScalars(VTK_FLOAT, 1)
    for k in range(size[2]):
        for j in range(size[1]):
            for i in range(size[0]):
                depth = radius - math.dist((i, j, k), middle)
                made.SetScalarComponentFromDouble(i, j, k, 0, float(depth > 0) if label else depth)
    return made


plain = image()
turned = tuple(o + d for o, d in zip(origin, (c * 18 - s * 12, s * 18 + c * 12, 11)))
unturned = tuple(o + m for o, m in zip(origin, middle))
bounds = plain.GetBounds()
corner = tuple(bounds[2 * a] + middle[a] for a in range(3))
places = {"with the Direction": turned, "as without a Direction": unturned, "from the corner of the bounds": corner}


def place(output):
    b = output.GetBounds()
    at = [(b[2 * a] + b[2 * a + 1]) / 2 for a in range(3)]
    names = [n for n, p in places.items() if math.dist(p, at) < 0.3]
    return at, names[0] if names else "elsewhere"


good = True


def state(name, output, expected):
    global good
    at, seen = place(output)
    good &= seen == expected
    print(f"{name:26} centre {at[0]:6.2f} {at[1]:6.2f} {at[2]:6.2f}  {seen}")


print("true centre of the ball    %13.2f %6.2f %6.2f" % turned)
W, O, C = places
for filter, expected in (
    (vtkMarchingCubes, W),
    (vtkFlyingEdges3D, W),
    (vtkDiscreteMarchingCubes, W),
    (vtkContourFilter, O),
    (vtkSynchronizedTemplates3D, O),
    (vtkClipVolume, W),
    (vtkTableBasedClipDataSet, C),
):
    f = filter()
    label = filter is vtkDiscreteMarchingCubes
    f.SetInputData(image(True) if label else plain)
    if hasattr(f, "SetNumberOfContours"):
        f.SetValue(0, 1.0 if label else 0.0)
    else:
        f.SetValue(0.0)
    f.Update()
    state(filter.__name__, f.GetOutput(), expected)

kept = []
for filter in (vtkImageGaussianSmooth, vtkImageCast, vtkImageReslice, vtkImageResample, vtkImageThreshold):
    f = filter()
    f.SetInputData(plain)
    f.Update()
    if not f.GetOutput().GetDirectionMatrix().IsIdentity():
        kept.append(filter.__name__)
print("imaging filters that hand on the Direction:", ", ".join(kept) or "none of five")
good &= not kept
smooth = vtkImageGaussianSmooth()
smooth.SetInputData(plain)
edges = vtkFlyingEdges3D()
edges.SetInputConnection(smooth.GetOutputPort())
edges.SetValue(0, 0.0)
edges.Update()
state("smooth, vtkFlyingEdges3D", edges.GetOutput(), O)
print("expected: every surface with the Direction, every image with its Direction")
sys.exit(0 if good else 1)
CODE
echo "python3-vtk9 $vtk"
LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu PYTHONPATH=$PWD/usr/lib/python3/dist-packages /usr/bin/python3 places.py
