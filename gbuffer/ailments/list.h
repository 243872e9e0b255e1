// Every ailment, in the order in which they are told: an ailment is one file in this folder and one line here.
// AILMENT(name): the file <name>.cpp defines `const Ailment ailment_<name>`.
#pragma once

#define RELUME_AILMENTS(AILMENT) \
  AILMENT(not_finite)            \
  AILMENT(zero_normals)          \
  AILMENT(long_normals)          \
  AILMENT(averted_normals)       \
  AILMENT(misplaced_normals)     \
  AILMENT(far_positions)         \
  AILMENT(coarse_positions)      \
  AILMENT(contradicting_depth)   \
  AILMENT(out_of_range)          \
  AILMENT(ids)                   \
  AILMENT(mixed_pixels)          \
  AILMENT(camera)                \
  AILMENT(lossy_codec)           \
  AILMENT(windows)               \
  AILMENT(duplicate_layers)      \
  AILMENT(thin_channels)         \
  AILMENT(missing_layers)        \
  AILMENT(unsure)
