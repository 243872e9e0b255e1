// TextbookKernel: buffers copied to the device, arguments set once.
#include "bench/textbook_kernel.h"

#include "bench/own_kernel.h"
#include "bench/texts.h"

namespace relume::bench {

struct TextbookKernel::Bound {
  OwnProgram program;
  std::vector<cl::Buffer> inputs{};
  cl::Buffer out{};
  cl::Kernel kernel{};
};

TextbookKernel::TextbookKernel(const BenchDevice& device, const Yardstick& yardstick, YardstickScene& scene, bool with_pow) {
  const std::string options = std::string("-DSPECULAR=") + yardstick.lobe + (with_pow ? " -DPOW" : "");
  bound_ = std::make_unique<Bound>(Bound{OwnProgram(device.info, text_textbook, options)});
  Bound& b = *bound_;
  const GBuffer& gbuffer = scene.gbuffer();
  const std::vector<float> lights = scene.light_records();
  for (const PlaneRange range : {gbuffer.position, gbuffer.normal, gbuffer.roles.at("albedo"), gbuffer.roles.at("alpha")})
    b.inputs.push_back(b.program.buffer(scene.plane(range), scene.stride() * std::size_t(range.count)));
  b.inputs.push_back(b.program.buffer(lights.data(), lights.size()));
  b.out = b.program.buffer(3 * scene.stride());
  b.kernel = b.program.kernel("shade");
  for (cl_uint plane = 0; plane < 4; ++plane) b.kernel.setArg(plane, b.inputs[plane]);
  b.kernel.setArg(4, cl_int(scene.stride()));
  b.kernel.setArg(5, b.inputs[4]);
  b.kernel.setArg(6, cl_int(yardstick_lights));
  b.kernel.setArg(7, cl_float3{{scene.eye()[0], scene.eye()[1], scene.eye()[2], 0}});
  b.kernel.setArg(8, b.out);
}

TextbookKernel::~TextbookKernel() = default;

void TextbookKernel::shade(int pixels) { bound_->program.run(bound_->kernel, std::size_t(pixels)); }

void TextbookKernel::read(Planes& out) { bound_->program.read(bound_->out, out.data(), 3 * out.stride()); }

}  // namespace relume::bench
