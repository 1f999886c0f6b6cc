/*
 * glTF 2.0 and GLB through tinygltf (Khronos, glTF 2.0 specification, sections 3.5-3.7). tinygltf
 * parses the JSON and fetches the buffers; every reference and every byte range is checked here,
 * because it checks few of them.
 */
#include "mesh/format.h"

extern "C" {
#include "base/file.h"
#include "base/phrase.h"
}

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include <tiny_gltf.h>

namespace {

/* Deeper JSON is not a mesh; tinygltf walks some of it by recursion. */
const int most_levels = 64;

/* Nodes may repeat a mesh, so a small file can ask for any amount of memory. */
const size_t most_corners = (size_t)1 << 25;

struct failure {
    kg_status status;
    std::string message;
};

/* Says it in the user's language. */
[[noreturn]] void refuse(const char *message) {
    throw failure{KG_ERR_PARSE, kg_phrase(message)};
}

/* The item with this index, as references in the file give it. */
template <class T>
const T &at(const std::vector<T> &items, int index, const char *what) {
    if (index < 0 || (size_t)index >= items.size()) {
        char message[128];
        kg_phrase_print(message, sizeof message, "it refers to a %s that does not exist", what);
        throw failure{KG_ERR_PARSE, message};
    }
    return items[(size_t)index];
}

/* ---- numbers --------------------------------------------------------------------------- */

struct byte_range {
    const unsigned char *data;
    size_t size;
};

byte_range view_bytes(const tinygltf::Model &model, int view_index) {
    const tinygltf::BufferView &view = at(model.bufferViews, view_index, "bufferView");
    const std::vector<unsigned char> &data = at(model.buffers, view.buffer, "buffer").data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        refuse("a bufferView ends behind its buffer");
    return {data.data() + view.byteOffset, view.byteLength};
}

size_t component_size(int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        refuse("an accessor has an unknown componentType");
    }
}

template <class T>
double load(const unsigned char *bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return (double)value;
}

double component(const unsigned char *bytes, int type, bool normalized) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return normalized ? std::fmax(load<int8_t>(bytes) / 127, -1) : load<int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<uint8_t>(bytes) / (normalized ? 255 : 1);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return normalized ? std::fmax(load<int16_t>(bytes) / 32767, -1) : load<int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<uint16_t>(bytes) / (normalized ? 65535 : 1);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<uint32_t>(bytes);
    default:
        return load<float>(bytes);
    }
}

/* `count` items of `width` components of one type in a range of bytes. */
struct number_array {
    byte_range bytes;
    size_t stride, count, width;
    int type;
    bool normalized;

    number_array(byte_range range, size_t offset, size_t given_stride, size_t item_count,
                 size_t item_width, int component_type, bool is_normalized)
        : bytes(range), stride(given_stride), count(item_count), width(item_width),
          type(component_type), normalized(is_normalized) {
        size_t size = component_size(type) * width;
        if (!stride)
            stride = size;
        if (offset > bytes.size)
            refuse("an accessor starts behind its bufferView");
        bytes.data += offset;
        bytes.size -= offset;
        if (count && (size > bytes.size || (count - 1) > (bytes.size - size) / stride))
            refuse("an accessor ends behind its bufferView");
    }

    double get(size_t item, size_t i) const {
        return component(bytes.data + item * stride + i * component_size(type), type, normalized);
    }
};

/* All numbers of an accessor, with the sparse ones in their places. */
std::vector<double> read_accessor(const tinygltf::Model &model, int index, int type) {
    const tinygltf::Accessor &a = at(model.accessors, index, "accessor");
    if (a.type != type)
        refuse("an accessor of positions, normals or indices has another type");
    size_t width = type == TINYGLTF_TYPE_VEC3 ? 3 : 1;
    if (a.count > most_corners)
        refuse("an accessor has too many items");
    std::vector<double> values;
    if (a.bufferView >= 0) {
        byte_range range = view_bytes(model, a.bufferView);
        size_t stride = model.bufferViews[(size_t)a.bufferView].byteStride;
        number_array items(range, a.byteOffset, stride, a.count, width, a.componentType,
                           a.normalized);
        values.reserve(a.count * width);
        for (size_t i = 0; i < a.count * width; i++)
            values.push_back(items.get(i / width, i % width));
    } else {
        values.resize(a.count * width);
    }
    if (!a.sparse.isSparse)
        return values;
    if (a.sparse.count < 0 || a.sparse.indices.byteOffset < 0 || a.sparse.values.byteOffset < 0)
        refuse("a sparse accessor has a negative count or offset");
    size_t count = (size_t)a.sparse.count;
    number_array places(view_bytes(model, a.sparse.indices.bufferView),
                        (size_t)a.sparse.indices.byteOffset, 0, count, 1,
                        a.sparse.indices.componentType, false);
    number_array items(view_bytes(model, a.sparse.values.bufferView),
                       (size_t)a.sparse.values.byteOffset, 0, count, width, a.componentType,
                       a.normalized);
    for (size_t i = 0; i < count; i++) {
        double place = places.get(i, 0);
        if (!(place >= 0 && place < (double)a.count))
            refuse("a sparse accessor changes an item that it does not have");
        for (size_t k = 0; k < width; k++)
            values[(size_t)place * width + k] = items.get(i, k);
    }
    return values;
}

/* ---- nodes ----------------------------------------------------------------------------- */

/* Affine, columns x y z and the origin. */
struct frame {
    kg_vec3 x, y, z, origin;
};

kg_vec3 turn(const frame &f, kg_vec3 v) {
    return kg_madd(kg_madd(kg_scale(f.x, v.x), v.y, f.y), v.z, f.z);
}

frame product(const frame &a, const frame &b) {
    return {turn(a, b.x), turn(a, b.y), turn(a, b.z), kg_add(turn(a, b.origin), a.origin)};
}

/* glTF is y-up. */
const frame z_up = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 0}};

kg_vec3 vector_of(const std::vector<double> &v, size_t first, kg_vec3 otherwise) {
    return v.size() >= first + 3 ? kg_v3(v[first], v[first + 1], v[first + 2]) : otherwise;
}

frame frame_of(const tinygltf::Node &node) {
    if (node.matrix.size() == 16)
        return {vector_of(node.matrix, 0, {}), vector_of(node.matrix, 4, {}),
                vector_of(node.matrix, 8, {}), vector_of(node.matrix, 12, {})};
    kg_vec3 s = vector_of(node.scale, 0, kg_v3(1, 1, 1));
    std::vector<double> q = node.rotation;
    if (q.size() != 4)
        q = {0, 0, 0, 1};
    double x = q[0], y = q[1], z = q[2], w = q[3], n = x * x + y * y + z * z + w * w;
    double k = n > 0 ? 2 / n : 0;
    return {kg_scale(kg_v3(1 - k * (y * y + z * z), k * (x * y + w * z), k * (x * z - w * y)), s.x),
            kg_scale(kg_v3(k * (x * y - w * z), 1 - k * (x * x + z * z), k * (y * z + w * x)), s.y),
            kg_scale(kg_v3(k * (x * z + w * y), k * (y * z - w * x), 1 - k * (x * x + y * y)), s.z),
            vector_of(node.translation, 0, kg_v3(0, 0, 0))};
}

/* ---- primitives ------------------------------------------------------------------------ */

class loader {
  public:
    loader(const tinygltf::Model &the_model, kg_mesh_builder *builder, kg_error *the_error)
        : model(the_model), b(builder), error(the_error) {}

    void add_all() {
        std::vector<char> is_child(model.nodes.size());
        for (const tinygltf::Node &node : model.nodes) {
            for (int child : node.children)
                at(model.nodes, child, "node"), is_child[(size_t)child] = 1;
        }
        seen.assign(model.nodes.size(), 0);
        for (const tinygltf::Scene &scene : model.scenes) {
            for (int root : scene.nodes)
                add_tree(root);
        }
        for (size_t i = 0; model.scenes.empty() && i < model.nodes.size(); i++) {
            if (!is_child[i])
                add_tree((int)i);
        }
        for (size_t i = 0; model.nodes.empty() && i < model.meshes.size(); i++)
            add_mesh((int)i, "", z_up);
    }

  private:
    const tinygltf::Model &model;
    kg_mesh_builder *b;
    kg_error *error;
    std::vector<char> seen; /* nodes; a node stands in one place only, so a circle ends */

    void check(kg_status status) {
        if (status)
            throw failure{status, ""};
    }

    /* As if the second half of the file were read while its vertices and corners are added: what
     * they take in it is not known, but about four bytes a number is. */
    void go_on() {
        size_t bytes = 12 * b->positions.count + 4 * b->corners.count;
        check(kg_mesh_builder_at(b, b->size / 2 + bytes / 2, error));
    }

    void add_tree(int root) {
        std::vector<std::pair<int, frame>> pending = {{root, z_up}};
        while (!pending.empty()) {
            auto [index, parent] = pending.back();
            pending.pop_back();
            const tinygltf::Node &node = at(model.nodes, index, "node");
            if (seen[(size_t)index])
                continue;
            seen[(size_t)index] = 1;
            frame f = product(parent, frame_of(node));
            if (node.mesh >= 0)
                add_mesh(node.mesh, node.name, f);
            for (size_t i = node.children.size(); i-- > 0;)
                pending.push_back({node.children[i], f});
        }
    }

    void add_mesh(int index, const std::string &node_name, const frame &f) {
        const tinygltf::Mesh &mesh = at(model.meshes, index, "mesh");
        std::string name = !node_name.empty() ? node_name : mesh.name;
        if (name.empty())
            name = "mesh " + std::to_string(index + 1);
        for (const tinygltf::Primitive &primitive : mesh.primitives)
            add_primitive(primitive, name, f);
    }

    void add_primitive(const tinygltf::Primitive &primitive, const std::string &name,
                       const frame &f) {
        auto position = primitive.attributes.find("POSITION");
        bool has_faces = primitive.mode >= TINYGLTF_MODE_TRIANGLES &&
                         primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN;
        if (!has_faces || position == primitive.attributes.end())
            return;
        float color[4];
        std::memcpy(color, kg_mesh_plain_color, sizeof color);
        if (primitive.material >= 0) {
            const tinygltf::Material &m = at(model.materials, primitive.material, "material");
            const std::vector<double> &base = m.pbrMetallicRoughness.baseColorFactor;
            for (size_t i = 0; i < 4 && base.size() == 4; i++)
                color[i] = (float)std::fmin(std::fmax(base[i], 0), 1);
        }
        check(kg_mesh_builder_group(b, name.data(), std::strlen(name.c_str()), color, error));
        size_t first = b->positions.count;
        add_vertices(position->second, f);
        auto normal = primitive.attributes.find("NORMAL");
        if (normal != primitive.attributes.end())
            add_normals(normal->second, b->positions.count - first, f);
        add_triangles(primitive, (int64_t)first, b->positions.count - first,
                      kg_det(f.x, f.y, f.z) < 0);
    }

    void add_vertices(int accessor, const frame &f) {
        std::vector<double> p = read_accessor(model, accessor, TINYGLTF_TYPE_VEC3);
        if (p.size() / 3 > most_corners - b->positions.count)
            refuse("its nodes repeat meshes too often to be loaded");
        for (size_t i = 0; i < p.size(); i += 3) {
            kg_vec3 placed = kg_add(turn(f, kg_v3(p[i], p[i + 1], p[i + 2])), f.origin);
            check(kg_mesh_builder_position(b, placed, 0, error));
            go_on();
        }
    }

    /* By the cofactors of the frame, as kg_mesh_transform does. One that is missing or without a
     * direction leaves the builder without normals. */
    void add_normals(int accessor, size_t vertex_count, const frame &f) {
        if (at(model.accessors, accessor, "accessor").count != vertex_count)
            return;
        std::vector<double> p = read_accessor(model, accessor, TINYGLTF_TYPE_VEC3);
        kg_vec3 x = kg_cross(f.y, f.z), y = kg_cross(f.z, f.x), z = kg_cross(f.x, f.y);
        double sign = kg_det(f.x, f.y, f.z) < 0 ? -1 : 1;
        for (size_t i = 0; i < p.size(); i += 3) {
            kg_vec3 n = turn({x, y, z, {}}, kg_v3(p[i], p[i + 1], p[i + 2]));
            double length = kg_len(n);
            if (length > 0 && std::isfinite(length))
                check(kg_mesh_builder_normal(b, kg_scale(n, sign / length), error));
        }
    }

    void add_triangles(const tinygltf::Primitive &primitive, int64_t first, size_t vertex_count,
                       bool mirrored) {
        std::vector<double> index;
        bool indexed = primitive.indices >= 0;
        if (indexed)
            index = read_accessor(model, primitive.indices, TINYGLTF_TYPE_SCALAR);
        size_t count = indexed ? index.size() : vertex_count;
        if (count > most_corners || 3 * count > 3 * most_corners - b->corners.count)
            refuse("its nodes repeat meshes too often to be loaded");
        bool separate = primitive.mode == TINYGLTF_MODE_TRIANGLES;
        for (size_t i = 0; i + 2 < count; i += separate ? 3 : 1) {
            size_t c[3] = {i, i + 1, i + 2};
            if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN)
                c[0] = 0;
            if ((primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1) != mirrored)
                std::swap(c[1], c[2]);
            for (size_t corner : c) {
                double v = indexed ? index[corner] : (double)corner;
                if (!(v >= 0 && v < (double)vertex_count))
                    refuse("a triangle has a vertex that does not exist");
                check(kg_mesh_builder_corner(b, first + (int64_t)v, error));
            }
            check(kg_mesh_builder_end_face(b, 0, error));
            go_on();
        }
    }
};

/* ---- file ------------------------------------------------------------------------------ */

/* Whether brackets nest deeper than most_levels. */
bool is_too_deep(byte_range json) {
    const unsigned char *s = json.data;
    int level = 0;
    bool in_string = false;
    for (size_t i = 0; i < json.size; i++) {
        if (in_string) {
            if (s[i] == '\\')
                i++;
            else if (s[i] == '"')
                in_string = false;
        } else if (s[i] == '"') {
            in_string = true;
        } else if ((s[i] == '{' || s[i] == '[') && ++level > most_levels) {
            return true;
        } else if (s[i] == '}' || s[i] == ']') {
            level--;
        }
    }
    return false;
}

bool file_exists(const std::string &, void *folder) {
    return folder != nullptr;
}

std::string keep_path(const std::string &path, void *) {
    return path;
}

/* Only reads buffers beside the file, by kg_file_read. */
bool read_file(std::vector<unsigned char> *out, std::string *message, const std::string &path,
               void *folder) {
    kg_error error = {};
    char *data;
    size_t size;
    if (!folder || kg_file_read(path.c_str(), &data, &size, &error)) {
        *message += error.message;
        return false;
    }
    try {
        out->assign((unsigned char *)data, (unsigned char *)data + size);
    } catch (...) {
        std::free(data);
        throw;
    }
    std::free(data);
    return true;
}

bool write_nothing(std::string *, const std::string &, const std::vector<unsigned char> &, void *) {
    return false;
}

bool skip_image(tinygltf::Image *, const int, std::string *, std::string *, int, int,
                const unsigned char *, int, void *) {
    return true;
}

void load_model(const void *data, size_t size, const char *folder, tinygltf::Model *model) {
    const char *text = (const char *)data;
    bool binary = size >= 4 && std::memcmp(text, "glTF", 4) == 0;
    if (size > UINT32_MAX)
        refuse("it is larger than 4 GB");
    byte_range json = {(const unsigned char *)data, size};
    if (binary && size >= 20) /* a header of 12 bytes, then the JSON chunk with one of 8 */
        json = {json.data + 20, std::min(size - 20, (size_t)load<uint32_t>(json.data + 12))};
    if (is_too_deep(json))
        refuse("its JSON nests too deeply");
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(skip_image, nullptr);
    parser.SetFsCallbacks(
        {file_exists, keep_path, read_file, write_nothing, const_cast<char *>(folder)});
    std::string message, warning, base = folder ? folder : "";
    bool ok =
        binary ? parser.LoadBinaryFromMemory(model, &message, &warning, (const unsigned char *)data,
                                             (unsigned)size, base)
               : parser.LoadASCIIFromString(model, &message, &warning, text, (unsigned)size, base);
    if (!ok) {
        message = message.substr(0, message.find('\n'));
        refuse(message.empty() ? N_("not a glTF file") : message.c_str());
    }
}

} // namespace

extern "C" kg_status kg_gltf_read(const void *data, size_t size, const char *folder,
                                  kg_mesh_builder *b, kg_error *error) try {
    tinygltf::Model model;
    load_model(data, size, folder, &model);
    loader(model, b, error).add_all();
    return KG_OK;
} catch (const failure &f) {
    if (f.message.empty())
        return f.status; /* told by the builder */
    return kg_fail(error, f.status, "%s: %.400s: export the mesh again", b->name,
                   f.message.c_str());
} catch (const std::bad_alloc &) {
    return kg_mesh_builder_memory(b, error);
} catch (const std::exception &e) {
    return kg_fail(error, KG_ERR_PARSE, "%s: not a valid glTF file: %.400s", b->name, e.what());
}
