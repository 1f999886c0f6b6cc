#include "tests/mesh/openmesh.h"

#include <cstdlib>
#include <cstring>
#include <sstream>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

extern "C" bool kg_openmesh_convert(const void *data, size_t size, const char *from,
                                    bool from_binary, const char *to, bool to_binary,
                                    char **out_data, size_t *out_size) try {
    using OpenMesh::IO::Options;
    omlog().disable();
    omerr().disable();
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    std::istringstream in(std::string((const char *)data, size));
    std::ostringstream out;
    Options read_options = from_binary ? Options::Binary : Options::Default;
    Options write_options = to_binary ? Options::Binary : Options::Default;
    if (!OpenMesh::IO::read_mesh(mesh, in, from, read_options) ||
        !OpenMesh::IO::write_mesh(mesh, out, to, write_options, 9))
        return false;
    std::string bytes = out.str();
    *out_data = (char *)std::malloc(bytes.size() + 1);
    if (!*out_data)
        return false;
    std::memcpy(*out_data, bytes.data(), bytes.size());
    *out_size = bytes.size();
    return true;
} catch (...) {
    return false;
}
