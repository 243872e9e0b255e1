// Disney's principled highlight and clearcoat: Burley 2012, "Physically-Based Shading at Disney", as Mitsuba 3's principled evaluates them
// (exact dielectric Fresnel, separable Smith shadowing, and a clearcoat without 1/(4 n.l n.v)).
#ifndef RELUME_SPECULAR_PRINCIPLED_H
#define RELUME_SPECULAR_PRINCIPLED_H

#include "kernels/cosines.h"
#include "kernels/fresnel/dielectric.h"
#include "kernels/fresnel/schlick.h"
#include "kernels/math.h"
#include "kernels/microfacet/ggx.h"
#include "kernels/surface.h"
#include "kernels/tint.h"

/// Dielectric, metal and tinted dielectric by their shares; the latter two by Schlick.
RELUME_FN real3 principled_fresnel(Surface s, real v_h) {
  const real dielectric = dielectric_reflectance(s.ior, v_h);
  const real weight = schlick_weight(v_h);
  const real3 white = grey(all_lanes(1.0f));
  const real3 metal = mix3(s.albedo, white, weight);
  const real3 tinted = mix3(scale3(base_tint(s), squared((s.ior - 1.0f) / (s.ior + 1.0f))), white, weight);
  const real3 f = mix3(mix3(grey(dielectric), tinted, s.spec_tint), metal, s.metallic);
  return choose3(dielectric > 0.0f, f, grey(all_lanes(0.0f)));  // at ior 1 Mitsuba has no highlight at all, metal or not
}

/// 0.25 clearcoat F D G n.l; D is GTR1 with alpha 0.1 (dull) to 0.001 (glossy), F Schlick with f0 0.04, G Smith's for alpha 0.25.
RELUME_FN real principled_clearcoat(Cosines c, Surface s, real v_h) {
  const real alpha = 0.001f * s.clearcoat_gloss + (0.1f - 0.1f * s.clearcoat_gloss);  // exact at both ends
  const real alpha2 = alpha * alpha;
  // GTR1 = (a^2 - 1)/(pi ln a^2 (1 + (a^2 - 1) cos^2)), with the last factor as cos^2 (a^2 + tan^2), which does not cancel.
  const real log_alpha2 = -log1p_of(1.0f / alpha2 - 1.0f);  // of the large 1/a^2: a^2 - 1 would lose what a small a^2 holds
  const real d = RELUME_INVERSE_PI * (alpha2 - 1.0f) / log_alpha2 * c.sum2 / (c.across2 + alpha2 * c.along2);
  const real f = 0.04f + 0.96f * schlick_weight(v_h);
  const real g = ggx_smith_separable_visibility(c, all_lanes(0.25f)) * 4.0f * c.n_v;
  return 0.25f * s.clearcoat * d * f * g * c.n_l;
}

RELUME_FN real3 specular_principled(Cosines c, Surface s) {
  const real alpha = larger(s.roughness * s.roughness, all_lanes(0.001f));  // Mitsuba's least
  const real h = v_h(c);
  const real lobe = ggx_distribution(c, alpha) * ggx_smith_separable_visibility(c, alpha);
  return add3(scale3(principled_fresnel(s, h), lobe), grey(principled_clearcoat(c, s, h)));
}

#endif
