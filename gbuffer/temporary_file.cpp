// TemporaryFile: mkstemps, and the list that a crash's sweep knows.
#include "gbuffer/temporary_file.h"

#include <unistd.h>

#include <cstdlib>

#include "gbuffer/error.h"
#include "gbuffer/temporaries.h"

namespace relume {

TemporaryFile::TemporaryFile(const std::string& ending) {
  std::string name = (std::filesystem::temp_directory_path() / ("relume-XXXXXX" + ending)).string();
  const int descriptor = mkstemps(name.data(), int(ending.size()));
  if (descriptor < 0) throw Error(ErrorKind::output, name + ": no temporary file (is TMPDIR full?)");
  close(descriptor);
  path_ = name;
  slot_ = note_temporary(path_);
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  forget_temporary(slot_);
}

}  // namespace relume
