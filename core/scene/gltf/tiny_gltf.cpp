// tinygltf's own code, which is all in its header. It is compiled here and not taken from Debian's libtinygltf.so, because
// Debian's Draco exports the symbols of an older tinygltf, which would take the place of that library's and crash. So the
// sanitizers watch it, too.
#include <fstream>
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include "core/scene/gltf/tiny_gltf.h"
