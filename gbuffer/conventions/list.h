// Every convention; of those for which a file speaks equally the first is taken. A renderer is one file in this folder and one line here.
// CONVENTION(name): the file defines `const Convention convention_<name>`.
#pragma once

#define RELUME_CONVENTIONS(CONVENTION) \
  CONVENTION(blender)                  \
  CONVENTION(relume_bake)              \
  CONVENTION(pbrt)                     \
  CONVENTION(mitsuba)                  \
  CONVENTION(arnold)                   \
  CONVENTION(vray)                     \
  CONVENTION(karma)                    \
  CONVENTION(redshift)                 \
  CONVENTION(unreal)                   \
  CONVENTION(delight)                  \
  CONVENTION(corona)                   \
  CONVENTION(octane)                   \
  CONVENTION(luxcore)                  \
  CONVENTION(renderman)                \
  CONVENTION(mantra)                   \
  CONVENTION(moonray)                  \
  CONVENTION(iray)                     \
  CONVENTION(cinema4d)                 \
  CONVENTION(gaffer)                   \
  CONVENTION(scanline)                 \
  CONVENTION(nuke)                     \
  CONVENTION(oiio)                     \
  CONVENTION(generic)  // common names; takes every file, so it stays last
