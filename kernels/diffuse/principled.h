// Disney's principled diffuse, flat subsurface and sheen: Burley 2012, "Physically-Based Shading at Disney", and 2015, "Extending the Disney BRDF to
// a BSDF with Integrated Subsurface Scattering", as Mitsuba 3's principled evaluates them (its sheen has no 1/pi).
#ifndef RELUME_DIFFUSE_PRINCIPLED_H
#define RELUME_DIFFUSE_PRINCIPLED_H

#include "kernels/cosines.h"
#include "kernels/fresnel/schlick.h"
#include "kernels/surface.h"
#include "kernels/tint.h"

RELUME_FN real3 diffuse_principled(Cosines c, Surface s) {
  const real n_v = larger(c.n_v, all_lanes(0.0f));
  const real light = schlick_weight(c.n_l);
  const real view = schlick_weight(n_v);
  const real retro = 0.5f * s.roughness * c.sum2;  // 2 roughness (l.h)^2
  const real smooth = (1.0f - 0.5f * light) * (1.0f - 0.5f * view);
  const real round = smooth + retro * (light + view + light * view * (retro - 1.0f));
  const real rise = 0.5f * retro - 1.0f;  // Fss90 - 1
  const real spread = (1.0f + rise * light) * (1.0f + rise * view);
  const real flat = 1.25f * (spread * (1.0f / (c.n_l + n_v) - 0.5f) + 0.5f);
  const real3 base = scale3(s.albedo, RELUME_INVERSE_PI * (round + (flat - round) * s.flatness));
  const real3 sheen_colour = mix3(grey(all_lanes(1.0f)), base_tint(s), s.sheen_tint);
  const real3 sheen = scale3(sheen_colour, s.sheen * schlick_weight(v_h(c)));
  return scale3(add3(base, sheen), (1.0f - s.metallic) * c.n_l);
}

#endif
