// The objects of a file, for `relume inspect`: every Cryptomatte and the id layer, with names and pixel counts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gbuffer/object_ids.h"

namespace relume {

/// Counts objects in bands that inspect reads anyway.
class InspectedObjects {
 public:
  /// Adds the layers' roles to `reading`.
  InspectedObjects(const ExrFile& file, Reading& reading);

  /// For read_gbuffer.
  std::vector<std::string> roles() const;
  void add(const GBuffer& gbuffer);
  nlohmann::ordered_json json() const;

 private:
  struct Counted {
    ObjectIds layer;
    ObjectCounts counts;
  };
  std::vector<Counted> layers_;
  nlohmann::ordered_json unusable_ = nlohmann::ordered_json::array();  ///< those with a defect
};

/// A line for each layer: the objects that fill most pixels, and how many more there are.
void print_objects(const nlohmann::ordered_json& layers);

}  // namespace relume
