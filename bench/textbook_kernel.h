// bench/textbook.cl on a device, over the yardsticks' scene.
#pragma once

#include <functional>
#include <memory>

#include "bench/bench_device.h"
#include "bench/yardstick_scene.h"

namespace relume::bench {

class TextbookKernel {
 public:
  /// `with_pow`: pow(x, 5) for powers, else x*x*x*x*x.
  TextbookKernel(const BenchDevice& device, const Yardstick& yardstick, YardstickScene& scene, bool with_pow);
  ~TextbookKernel();

  void shade(int pixels);
  void read(Planes& out);

 private:
  struct Bound;
  std::unique_ptr<Bound> bound_;
};

}  // namespace relume::bench
