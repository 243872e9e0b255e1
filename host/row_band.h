// Rows of a table as the pixels of a made-up band, for the kernel that evaluates lobes alone: cosines in place of positions, parameters as layers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gbuffer/gbuffer.h"
#include "gbuffer/reading.h"
#include "host/binding.h"
#include "host/cosines.h"
#include "host/device.h"

namespace relume {

class RowBand {
 public:
  explicit RowBand(std::span<const PreciseCosines> cosines);

  /// A parameter that differs from row to row: one column, or three of one length.
  void add_parameter(const std::string& name, std::span<const std::vector<double>> columns);

  /// Room for what a binding places beside the columns.
  GBuffer& gbuffer() { return gbuffer_; }
  /// The parameters as roles, for a binding.
  Reading& reading() { return reading_; }

  /// f_r n.l of every row: planes 0..2 the diffuse lobe, 3..5 the specular one.
  Planes evaluate(Device& device, const Binding& binding);
  /// Of every row: plane 0 D of this distribution, 1 G and 3..5 F of the binding's terms (kernels/terms.h).
  Planes terms(Device& device, const Binding& binding, int distribution);

 private:
  Planes run(Device& device, const Binding& binding, Entry entry, const Choice& choice);

  GBuffer gbuffer_;
  Reading reading_;
};

}  // namespace relume
