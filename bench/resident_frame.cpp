// The host's own Binding fills the planes and fields, so that kernels are measured on what `relume shade` would give them.
#include "bench/resident_frame.h"

#include <algorithm>

#include "host/binding.h"

namespace relume::bench {
namespace {

/// A reading of a file that has all roles of the source.
Reading reading_of(const FrameSource& source) {
  Reading reading;
  for (const std::string& role : source.roles) reading.roles[role] = {};
  reading.camera = source.camera;
  return reading;
}

RoleLayer no_layer(const std::string&) { return {}; }

}  // namespace

ResidentFrame::ResidentFrame(const FrameSource& source, const Material& material) : gbuffer_{{}, Planes(1, 1), {}, {}, {}, {}, false, {}, {}} {
  Reading reading = reading_of(source);
  const Binding binding(material, {}, "bench", no_layer, reading);
  gbuffer_ = source.make(binding.roles(), binding.spare_planes());
  frame_.pixels = int(gbuffer_.samples());
  frame_.plane_stride = int(gbuffer_.planes.stride());
  frame_.position = gbuffer_.position.first;
  frame_.normal = gbuffer_.normal.first;
  frame_.base_normal = -1;
  const glm::dvec3 eye = source.camera.eye();
  for (int c = 0; c < 3; ++c) frame_.viewer[c] = float(eye[c]);
  frame_.viewer[3] = 1;
  frame_.diffuse = frame_.specular = frame_.ambient_out = -1;
  binding.bind(gbuffer_, source.camera, frame_);
  frame_.out_stride = int(make_out().stride());
  choice_ = binding.programs().front();
  tables_ = binding.tables();
}

void ResidentFrame::set_lights(const std::vector<Light>& lights, double error) {
  lights_ = light_records(lights);
  records_ = lights_.records;
  error_ = error;
  tree_ = error > 0 ? LightTree(records_, lights_.begin) : LightTree();
  sorted_ = {lights_.records, lights_.begin, tree_};
  std::copy(lights_.begin.begin(), lights_.begin.end(), frame_.light_begin);
}

int ResidentFrame::list_lights(LightLists& lists, FrameBounds& bounds) const {
  if (!tree_.empty())
    return lists.add(bounds, sorted_, LightCuts(tree_, {&choice_, 1}, tables_, error_),
                     LightLists::room_beside(gbuffer_.planes) + LightLists::room_for_cuts(gbuffer_.planes));
  return lists.add(bounds, sorted_, LightLists::room_beside(gbuffer_.planes));
}

Planes ResidentFrame::make_out() const {
  Planes out(gbuffer_.planes.pixels(), 3);
  out.add(3);
  return out;
}

}  // namespace relume::bench
