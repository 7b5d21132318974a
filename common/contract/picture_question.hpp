// One query per picture: one query per ray would take a hundred times as long.
#pragma once

#include "common/contract/contracts.hpp"
#include "common/contract/scene_bytes.hpp"
#include "common/render/render_settings.hpp"

namespace rt::contract {

/// The question of rendered(), common/contract/rendered.hpp.
inline std::string picture_question(const Scene& scene, const RenderSettings& settings, int every) {
    Writer question;
    put(question, Number{.stage = 0, .place = picture_place});
    put_scene(question, scene);
    put(question, settings);
    put(question, every);
    return question.bytes();
}

/// Throws Malformed if the answer is no picture of this size.
inline Image picture_in(const std::string& answer, Resolution size) {
    Reader reader(answer);
    Image image(size);
    const std::size_t pixels = image.pixels.size();
    image.pixels = get<std::vector<Rgb>>(reader);
    reader.end();
    if (image.pixels.size() != pixels) throw Malformed("a picture of a different size");
    return image;
}

}  // namespace rt::contract
