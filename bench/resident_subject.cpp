// resident_subject: brute force, every pixel under every light.
#include "bench/resident_subject.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "bench/image_check.h"

namespace relume::bench {
namespace {

constexpr std::int64_t checked_pixel_lights = 30'000'000;  // a tenth of a second of the twin's time

int checked_pixels(const ResidentFrame& frame) {
  const std::int64_t most = std::max<std::int64_t>(checked_pixel_lights / std::max(1, frame.lights()), 1024);
  return int(std::min<std::int64_t>(most, frame.frame().pixels));
}

/// Keeps alive what the band reads and writes.
struct Bound {
  std::shared_ptr<const ResidentFrame> frame;
  std::shared_ptr<Device> device;
  Planes out;
  std::unique_ptr<Band> band;
};

}  // namespace

ShadingCost cost_of(const ResidentFrame& frame) {
  Planes out = frame.make_out();
  return count_operations(frame.choice(), frame.frame(), frame.data(out));
}

Work work_of(const ResidentFrame& frame, double lit_pairs) {
  const ShadingCost cost = cost_of(frame);
  const double pixels = double(frame.gbuffer().surface_pixels);
  return {{{"brute", pixels * frame.lights()}}, pixels * cost.pixel.flops() + lit_pairs * cost.light.flops(), pixels * cost.pixel.bytes()};
}

Subject resident_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                         const Roof& roof) {
  const std::string verdict = check_image(*device, *frame, checked_pixels(*frame));
  const auto bound = std::make_shared<Bound>(Bound{frame, device, frame->make_out(), nullptr});
  bound->band = device->bind(frame->data(bound->out));
  const auto run = [bound] {
    bound->band->shade(bound->frame->choice(), bound->frame->frame(), {});
    bound->band->finish();
  };
  return {name, run, work_of(*frame, double(frame->gbuffer().surface_pixels) * frame->lights()), verdict, roof};
}

namespace {

/// Lists made anew in each go, and bounds unless they are held.
Subject listed_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                       const Roof& roof, double lit_pairs, const std::string& verdict, Bounds bounds) {
  const auto out = std::make_shared<Planes>(frame->make_out());
  const int threads = std::clamp(roof.threads, 1, int(std::max(1u, std::thread::hardware_concurrency())));
  const auto arena = std::make_shared<tbb::task_arena>(threads);  // lists are made on as many threads as the device has
  const auto lists = std::make_shared<LightLists>();
  const auto held = bounds == Bounds::held ? std::make_shared<FrameBounds>(frame->bounds()) : nullptr;
  const auto shade = [=] {
    lists->clear();
    std::optional<FrameBounds> anew;
    Frame listed = frame->frame();
    listed.lists = frame->list_lights(*lists, held ? *held : anew.emplace(frame->bounds()));
    const auto band = device->bind(frame->data(*out, lists->numbers()));
    band->shade(frame->choice(), listed, {});
    band->finish();
  };
  return {name, [=] { arena->execute(shade); }, work_of(*frame, lit_pairs), verdict, roof};
}

}  // namespace

Subject culled_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                       const Roof& roof, double lit_pairs, Bounds bounds) {
  return listed_subject(name, frame, device, roof, lit_pairs, check_culled_image(*device, *frame), bounds);
}

Subject cut_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                    const Roof& roof, double error) {
  LightLists lists;
  FrameBounds bounds = frame->bounds();
  Frame listed = frame->frame();
  listed.lists = frame->list_lights(lists, bounds);
  const double met = double(lights_met(listed, lists.numbers())) * double(frame->gbuffer().surface_pixels);
  Subject subject = listed_subject(name, frame, device, roof, met, check_cut_image(*device, *frame, error), Bounds::anew);
  subject.work.pixel_lights.push_back({"met", met});
  return subject;
}

}  // namespace relume::bench
