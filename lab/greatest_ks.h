// The greatest coefficient Ks with which Phong's and Blinn's lobes reflect no more than arrives, from the kernels and from closed forms.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "figure/figure.h"
#include "host/device.h"

namespace relume {

struct GreatestKs {
  std::string lobe;  ///< whose power of a cosine it is
  double exponent;
  double measured;  ///< the greatest f_r n.l over n.l (or f_r n.l, of the originals) over the greatest directional albedo
  double error;     ///< of the integration, relative
  double formula;   ///< docs/lab.md derives it
};

/// For exponents from 1 to 10,000.
std::vector<GreatestKs> greatest_ks(std::shared_ptr<Device> device);

/// Both against the exponent, and how far they are apart beneath.
Figure ks_figure(const std::vector<GreatestKs>& all);

/// lobe, exponent, measured, error, formula
std::string ks_csv(const std::vector<GreatestKs>& all);

}  // namespace relume
