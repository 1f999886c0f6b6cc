/* Pictures in the user interface, kept on the graphics card. */
#include "app/ui/state.hpp"

#include <epoxy/gl.h>

using namespace kg;

/* Textures that the last frame may still show. */
static std::vector<GLuint> doomed;

/* The widgets mix colours that are not premultiplied. */
static std::vector<uint8_t> plain_colors(const kg_image *image) {
    size_t count = (size_t)image->width * (size_t)image->height;
    std::vector<uint8_t> out(image->pixels, image->pixels + 4 * count);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 4 * i; k < 4 * i + 3 && out[4 * i + 3] > 0; k++)
            out[k] = (uint8_t)std::min(255, 255 * out[k] / out[4 * i + 3]);
    return out;
}

uint32_t kg_ui_picture_create(const kg_image *image) {
    GLint before;
    GLuint name;
    std::vector<uint8_t> pixels = plain_colors(image);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &before);
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image->width, image->height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, pixels.data());
    glBindTexture(GL_TEXTURE_2D, (GLuint)before);
    return name;
}

void kg_ui_picture_destroy(uint32_t picture) {
    if (picture)
        doomed.push_back(picture);
}

void kg::delete_pictures() {
    if (!doomed.empty())
        glDeleteTextures((GLsizei)doomed.size(), doomed.data());
    doomed.clear();
}

void kg_ui_canvas_picture(kg_area a, uint32_t picture, double opacity) {
    ui.canvas->AddImage((ImTextureID)(intptr_t)picture, ImVec2((float)a.x, (float)a.y),
                        ImVec2((float)(a.x + a.width), (float)(a.y + a.height)), ImVec2(0, 0),
                        ImVec2(1, 1), packed(kg_color{1, 1, 1, (float)opacity}));
}
