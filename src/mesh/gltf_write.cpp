/*
 * glTF 2.0 and GLB through tinygltf: one node, mesh and double-sided material per group, all
 * numbers in one buffer inside the file.
 */
#include "mesh/format.h"

#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <tiny_gltf.h>

namespace {

/* A run of faces that becomes one node. */
struct piece {
    const char *name;
    const float *color;
    size_t first_face, end_face;
};

/* The groups, and what lies between them. */
std::vector<piece> pieces_of(const kg_mesh *mesh) {
    std::vector<piece> pieces;
    size_t done = 0;
    for (size_t i = 0; i < mesh->group_count; i++) {
        const kg_mesh_group &g = mesh->groups[i];
        if (g.first_face > done)
            pieces.push_back({"default", kg_mesh_plain_color, done, g.first_face});
        done = g.first_face + g.face_count;
        if (g.face_count)
            pieces.push_back({g.name, g.color, g.first_face, done});
    }
    if (mesh->face_count > done)
        pieces.push_back({"default", kg_mesh_plain_color, done, mesh->face_count});
    return pieces;
}

class writer {
  public:
    tinygltf::Model model;

    writer(const kg_mesh *the_mesh, const uint32_t *the_triangles, const kg_mesh_motion *the_motion)
        : mesh(the_mesh), triangles(the_triangles), motion(the_motion),
          local(the_mesh->vertex_count, UINT32_MAX) {
        model.asset.version = "2.0";
        model.asset.generator = std::string("katagami ") + kg_version();
        model.buffers.emplace_back();
        model.scenes.emplace_back();
        model.defaultScene = 0;
        for (const piece &p : pieces_of(mesh))
            add(p);
        if (motion)
            add_animation();
    }

  private:
    const kg_mesh *mesh;
    const uint32_t *triangles;
    const kg_mesh_motion *motion; /* or null */
    std::vector<uint32_t> local;  /* index within the piece of each vertex in it */

    void add(const piece &p) {
        std::vector<uint32_t> vertices, indices;
        for (size_t t = triangle_of(p.first_face); t < triangle_of(p.end_face); t++) {
            for (size_t i = 0; i < 3; i++) {
                uint32_t v = triangles[3 * t + i];
                if (local[v] == UINT32_MAX) {
                    local[v] = (uint32_t)vertices.size();
                    vertices.push_back(v);
                }
                indices.push_back(local[v]);
            }
        }
        for (uint32_t v : vertices)
            local[v] = UINT32_MAX;

        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.attributes["POSITION"] = add_vectors(vertices, mesh->positions, true);
        if (mesh->normals && !motion)
            primitive.attributes["NORMAL"] = add_vectors(vertices, mesh->normals, false);
        primitive.indices =
            add_accessor(indices.data(), indices.size() * sizeof indices[0], indices.size(),
                         TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                         TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        primitive.material = add_material(p);
        tinygltf::Mesh made;
        made.name = p.name;
        for (size_t i = 0; motion && i < motion->target_count; i++) {
            primitive.targets.push_back(
                {{"POSITION", add_vectors(vertices, motion->displacements[i], true)}});
            made.weights.push_back(0);
        }
        made.primitives.push_back(primitive);
        tinygltf::Node node;
        node.name = p.name;
        node.mesh = (int)model.meshes.size();
        model.meshes.push_back(made);
        model.scenes[0].nodes.push_back((int)model.nodes.size());
        model.nodes.push_back(node);
    }

    /* All nodes move alike, by one sampler. */
    void add_animation() {
        std::vector<float> times(motion->times, motion->times + motion->key_count),
            weights(motion->weights, motion->weights + motion->key_count * motion->target_count);
        tinygltf::Animation animation;
        tinygltf::AnimationSampler sampler;
        animation.name = "motion";
        sampler.interpolation = "LINEAR";
        sampler.input = add_accessor(times.data(), times.size() * sizeof times[0], times.size(),
                                     TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, 0);
        sampler.output =
            add_accessor(weights.data(), weights.size() * sizeof weights[0], weights.size(),
                         TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, 0);
        tinygltf::Accessor &input = model.accessors[(size_t)sampler.input];
        input.minValues = {times.front()};
        input.maxValues = {times.back()};
        animation.samplers.push_back(sampler);
        for (size_t n = 0; n < model.nodes.size(); n++) {
            tinygltf::AnimationChannel channel;
            channel.sampler = 0;
            channel.target_node = (int)n;
            channel.target_path = "weights";
            animation.channels.push_back(channel);
        }
        model.animations.push_back(animation);
    }

    /* The first triangle of face f: the faces before it have n - 2 each. */
    size_t triangle_of(size_t f) const { return mesh->face_starts[f] - 2 * f; }

    int add_material(const piece &p) {
        tinygltf::Material m;
        m.name = p.name;
        m.doubleSided = true;
        m.pbrMetallicRoughness.baseColorFactor.assign(p.color, p.color + 4);
        m.pbrMetallicRoughness.metallicFactor = 0;
        m.pbrMetallicRoughness.roughnessFactor = 0.9; /* paper */
        if (p.color[3] < 1)
            m.alphaMode = "BLEND";
        model.materials.push_back(m);
        return (int)model.materials.size() - 1;
    }

    /* z-up to y-up: (x, y, z) -> (x, z, -y). */
    int add_vectors(const std::vector<uint32_t> &vertices, const kg_vec3 *vectors, bool bounded) {
        std::vector<float> numbers;
        for (uint32_t v : vertices) {
            numbers.push_back((float)vectors[v].x);
            numbers.push_back((float)vectors[v].z);
            numbers.push_back((float)-vectors[v].y);
        }
        int index = add_accessor(numbers.data(), numbers.size() * sizeof numbers[0],
                                 vertices.size(), TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                 TINYGLTF_TARGET_ARRAY_BUFFER);
        if (!bounded)
            return index;
        tinygltf::Accessor &a = model.accessors[(size_t)index];
        a.minValues.assign(numbers.begin(), numbers.begin() + 3);
        a.maxValues = a.minValues;
        for (size_t i = 0; i < numbers.size(); i++) {
            a.minValues[i % 3] = std::fmin(a.minValues[i % 3], (double)numbers[i]);
            a.maxValues[i % 3] = std::fmax(a.maxValues[i % 3], (double)numbers[i]);
        }
        return index;
    }

    int add_accessor(const void *data, size_t size, size_t count, int type, int component_type,
                     int target) {
        std::vector<unsigned char> &buffer = model.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = buffer.size();
        view.byteLength = size;
        view.target = target;
        const unsigned char *bytes = (const unsigned char *)data;
        buffer.insert(buffer.end(), bytes, bytes + size);
        tinygltf::Accessor accessor;
        accessor.bufferView = (int)model.bufferViews.size();
        accessor.componentType = component_type;
        accessor.count = count;
        accessor.type = type;
        model.bufferViews.push_back(view);
        model.accessors.push_back(accessor);
        return (int)model.accessors.size() - 1;
    }
};

} // namespace

extern "C" kg_status kg_gltf_write(const kg_mesh *mesh, const uint32_t *triangles,
                                   const kg_mesh_motion *motion, bool binary, kg_bytes *out,
                                   kg_error *error) try {
    writer w(mesh, triangles, motion);
    std::ostringstream stream;
    tinygltf::TinyGLTF gltf;
    if (w.model.buffers[0].data.size() > INT32_MAX ||
        !gltf.WriteGltfSceneToStream(&w.model, stream, !binary, binary))
        return kg_fail(error, KG_ERR_INPUT, "mesh: too large for a glTF file");
    std::string bytes = stream.str();
    kg_bytes_put(out, bytes.data(), bytes.size());
    return KG_OK;
} catch (const std::bad_alloc &) {
    return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for the file");
} catch (const std::exception &e) {
    return kg_fail(error, KG_ERR_INPUT,
                   "mesh: cannot be written as glTF (group names must be "
                   "UTF-8): %.300s",
                   e.what());
}
