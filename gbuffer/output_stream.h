// OpenEXR's output onto a WholeFile. The destructors of its output files swallow what a write throws, so the first failure is kept here.
#pragma once

#include <ImfIO.h>

#include <exception>

#include "gbuffer/whole_file.h"

namespace relume {

class OutputStream : public Imf::OStream {
 public:
  explicit OutputStream(WholeFile& file) : Imf::OStream("output"), file_(file) {}
  void write(const char data[], int bytes) override {
    keep([&] { file_.write(data, std::size_t(bytes)); });
  }
  uint64_t tellp() override { return file_.position(); }
  void seekp(uint64_t position) override {
    keep([&] { file_.seek(position); });
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Work>
  void keep(const Work& work) {
    try {
      work();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
      throw;
    }
  }

  WholeFile& file_;
  std::exception_ptr failure_;
};

}  // namespace relume
