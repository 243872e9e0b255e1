// Every way in which a header states a camera, the most telling first: a way is one file in this folder and one line here.
// CAMERA(name): the file defines `const HeaderCamera header_camera_<name>`.
#pragma once

#define RELUME_HEADER_CAMERAS(CAMERA) \
  CAMERA(vray)                        \
  CAMERA(matrices)                    \
  CAMERA(redshift)                    \
  CAMERA(unreal)                      \
  CAMERA(karma)                       \
  CAMERA(nuke)
