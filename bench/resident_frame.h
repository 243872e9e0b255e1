// A frame in memory under a material and lights, ready to be shaded on any device again and again.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gbuffer/gbuffer.h"
#include "host/brdf_name.h"
#include "host/device.h"
#include "host/light_lists.h"
#include "host/light_records.h"
#include "host/materials.h"

namespace relume::bench {

/// Pixels that are made when it is known which of their roles are read.
struct FrameSource {
  std::vector<std::string> roles;  ///< those that it can fill
  Camera camera;
  std::function<GBuffer(const std::vector<std::string>& roles, int spare_planes)> make;
};

class ResidentFrame {
 public:
  /// Binds the material to the frame's layers; parameters without a layer take their defaults.
  ResidentFrame(const FrameSource& source, const Material& material);

  /// Other lights: the pixels stay. `error`: through a light tree (host/light_cuts.h); 0: exact.
  void set_lights(const std::vector<Light>& lights, double error = 0);

  const Choice& choice() const { return choice_; }
  const Frame& frame() const { return frame_; }
  const GBuffer& gbuffer() const { return gbuffer_; }
  int lights() const { return int(lights_.records.size()); }
  /// Planes to shade into: total light, three planes.
  Planes make_out() const;
  /// `lists`: of list_lights, where Frame::lists says so.
  BandData data(Planes& out, std::span<const int> lists = {}) const { return {&gbuffer_.planes, records_, lists, tables_, &out}; }
  /// What bounds the pixels: nothing yet.
  FrameBounds bounds() const { return {gbuffer_.planes, frame_, gbuffer_.window.width()}; }
  /// Which lights can reach which pixels, worked out anew: what Frame::lists is to be.
  int list_lights(LightLists& lists, FrameBounds& bounds) const;

 private:
  GBuffer gbuffer_;
  Frame frame_{};
  Choice choice_{};
  std::vector<float> tables_;
  LightRecords lights_;
  std::vector<LightRecord> records_;  ///< the lights', and behind them what stands in for clusters of them
  double error_ = 0;
  LightTree tree_;
  SortedLights sorted_;
};

}  // namespace relume::bench
