# The Debian 12 packages that a build needs (the font is for the labels of relume doctor --png, gnuplot for relume bench --plots), and those that the tests need beside them. Sourced by ./demo and ./check.
build_packages=(g++ cmake ninja-build ocl-icd-opencl-dev opencl-clhpp-headers opencl-c-headers pocl-opencl-icd libglm-dev libopenexr-dev libimath-dev
  libopenimageio-dev libcli11-dev nlohmann-json3-dev libtinygltf-dev libeigen3-dev libtbb-dev libdeflate-dev fonts-dejavu-core
  libbenchmark-dev gnuplot-nox libassimp-dev libembree-dev)
# clang parses the kernels as OpenCL C; Mesa's rusticl and oclgrind are other OpenCL implementations that the same kernels must run on.
test_packages=(libgtest-dev clang mesa-opencl-icd oclgrind python3-pip)
