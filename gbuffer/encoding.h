// What OpenEXR throws while a file is written, as the Error of that file.
#pragma once

#include <new>
#include <string>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {

/// `name`: the file as messages name it.
template <class Work>
void while_encoding(const std::string& name, const Work& work) {
  try {
    work();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::memory, name + ": not enough memory to encode it");
  } catch (const std::exception& fault) {
    throw Error(ErrorKind::output, name + ": " + printable(fault.what()));
  }
}

}  // namespace relume
