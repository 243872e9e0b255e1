// Every convention, in the order in which they are asked whether a file is theirs: a renderer is one file in this folder and one line here.
// CONVENTION(name): the file defines `const Convention convention_<name>`.
#pragma once

#define RELUME_CONVENTIONS(CONVENTION) \
  CONVENTION(blender)                  \
  CONVENTION(pbrt)                     \
  CONVENTION(mitsuba)                  \
  CONVENTION(generic)  // plain names; takes every file, so it stays last
