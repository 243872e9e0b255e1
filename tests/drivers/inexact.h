// A device that is as inexact as OpenCL 1.2 lets one be (section 7.4: divide within 2.5 ulp, square root within 3), for machines that have none:
// the kernels as C++, over a number whose divide and square root err by a pseudo-random amount.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "host/device.h"
#include "host/frame.h"

#define RELUME_LANES 1
#define RELUME_LANGUAGE_H  // what follows stands in for kernels/language.h
#define RELUME_FN [[maybe_unused]] static inline
#define RELUME_GLOBAL
#define RELUME_LIGHT

namespace relume::inexact {

struct real {
  float value;
  real() = default;
  real(float x) : value(x) {}
};
typedef int integer;
typedef int mask;

/// A number in -1..1 that depends on the operands alone: a device errs the same way each time.
inline double error_of(float a, float b) {
  std::uint64_t x = std::uint64_t(std::bit_cast<std::uint32_t>(a)) << 32 | std::bit_cast<std::uint32_t>(b);
  x = (x ^ (x >> 31)) * 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9;
  return double(x >> 11) / double(std::uint64_t(1) << 52) - 1;
}

/// `exact` off by at most `ulps`, half of one for the rounding among them.
inline float inexact(double exact, double ulps, double error) {
  if (exact == 0 || !std::isfinite(exact) || std::fabs(exact) < 1.2e-38) return float(exact);
  return float(exact + (ulps - 0.5) * error * std::ldexp(1.0, std::ilogb(exact) - 23));
}

inline real operator+(real a, real b) { return a.value + b.value; }
inline real operator-(real a, real b) { return a.value - b.value; }
inline real operator*(real a, real b) { return a.value * b.value; }
inline real operator/(real a, real b) { return inexact(double(a.value) / double(b.value), 2.5, error_of(a.value, b.value)); }
inline real operator-(real a) { return -a.value; }
inline mask operator<(real a, real b) { return a.value < b.value; }
inline mask operator>(real a, real b) { return a.value > b.value; }
inline mask operator<=(real a, real b) { return a.value <= b.value; }
inline mask operator>=(real a, real b) { return a.value >= b.value; }
inline mask operator==(real a, real b) { return a.value == b.value; }

RELUME_FN real choose(mask m, real a, real b) { return m ? a : b; }
RELUME_FN integer choose_integer(mask m, integer a, integer b) { return m ? a : b; }
RELUME_FN real fused(real a, real b, real c) { return std::fma(a.value, b.value, c.value); }
RELUME_FN real square_root(real x) { return inexact(std::sqrt(double(x.value)), 3, error_of(x.value, 0)); }
RELUME_FN real whole_below(real x) { return std::floor(x.value); }
RELUME_FN real absolute(real x) { return std::fabs(x.value); }
RELUME_FN real as_real(integer x) { return std::bit_cast<float>(x); }
RELUME_FN integer as_integer(real x) { return std::bit_cast<integer>(x.value); }
RELUME_FN real to_real(integer x) { return static_cast<float>(x); }
RELUME_FN integer to_integer(real x) { return static_cast<int>(x.value); }
RELUME_FN real all_lanes(float x) { return x; }
RELUME_FN int any_of(mask m) { return m; }
RELUME_FN real load(const float* p) { return *p; }
RELUME_FN void store(real x, float* p) { *p = x.value; }
RELUME_FN void store_past_cache(real x, float* p) { store(x, p); }
RELUME_FN real gather(const float* table, integer index) { return table[index]; }

namespace {
#include "kernels/shade.h"
}

class InexactBand : public Band {
 public:
  explicit InexactBand(const BandData& data) : data_(data) {}
  void shade(const Choice& choice, const Frame& frame, const Progress&) override {
    for (int i = 0; i < frame.pixels; ++i)
      shade_pixels(choice, data_.planes->data(), &frame, data_.lights.data(), data_.lists.data(), data_.tables.data(), data_.out->data(), i);
  }
  void add_environment(Entry, const Choice&, const Frame&, const Progress&) override {}
  void run(Entry, const Choice&, const Frame&) override {}
  void finish() override {}

 private:
  BandData data_;
};

class InexactDevice : public Device {
 public:
  const DeviceInfo& info() const override { return info_; }
  std::unique_ptr<Band> bind(const BandData& data) override { return std::make_unique<InexactBand>(data); }

 private:
  DeviceInfo info_{.name = "inexact", .platform = "C++", .vendor = "relume", .version = "1.2", .driver = "emulated"};
};

}  // namespace relume::inexact
