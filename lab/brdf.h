// A BRDF as the laboratory sees it: lobes with constant parameters, evaluated for pairs of directions by the kernels that shade frames.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/binding.h"
#include "host/cosines.h"
#include "host/device.h"

namespace relume {

/// Unit vectors over a surface whose normal is +z.
struct DirectionPair {
  glm::dvec3 l, v;
};

/// f_r n.l of each lobe, 1/sr per channel; 0 where either direction is below the horizon.
struct Reflectance {
  glm::dvec3 diffuse, specular;
  glm::dvec3 total() const { return diffuse + specular; }
};

/// From the vectors, so that nothing cancels near the mirror direction, where sharp lobes live (DESIGN.md, "Shading in three cosines").
PreciseCosines cosines_of(const DirectionPair& pair);

/// open_device_or_twin (host/device_opening.h), for Brdfs to share: each has it pass the self-test of its own lobes.
std::shared_ptr<Device> lab_device(const std::string& selector);

class Brdf {
 public:
  /// `name`: a lobe ("ggx"; of both halves where both have it) or a pair, diffuse first ("lambert+ggx"). `set`: PARAM=VALUE. Error{input}.
  Brdf(const std::string& name, const std::vector<std::string>& set, std::shared_ptr<Device> device);

  std::vector<Reflectance> reflectance(std::span<const DirectionPair> pairs) const;

  const Binding& binding() const { return *binding_; }
  const std::string& name() const { return name_; }
  const Material& material() const { return material_; }

 private:
  std::string name_;
  Material material_;
  Reading reading_;
  std::unique_ptr<Binding> binding_;
  std::shared_ptr<Device> device_;
};

}  // namespace relume
