// Pictures as files.

#include "common/png.hpp"
#include "common/input_error.hpp"

#include "tests/kit/for_all.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

/// An empty folder, for as long as it lives. Both precisions may be tested at once.
class Scratch {
public:
    Scratch() : folder_(fs::path(sizeof(Real) == 4 ? "picture_float" : "picture_double")) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const {
        return (folder_ / name).string();
    }
    /// How many files and folders are in it, at any depth.
    [[nodiscard]] auto count() const {
        return std::distance(fs::recursive_directory_iterator(folder_), {});
    }

private:
    fs::path folder_;
};

Image noise(Resolution size) {
    Random random(7);
    Image image(size);
    for (Rgb& pixel : image.pixels)
        for (std::uint8_t& part : pixel) part = static_cast<std::uint8_t>(random.below(256));
    return image;
}

std::string content(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const std::string& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// The iTXt chunks of a PNG, as its specification lays them out.
std::vector<PngText> text_chunks(std::string_view png) {
    std::vector<PngText> texts;
    png.remove_prefix(8);  // the signature
    while (png.size() >= 12) {
        std::size_t length = 0;
        for (int i = 0; i < 4; ++i) length = length * 256 + std::uint8_t(png[std::size_t(i)]);
        const std::string_view data = png.substr(8, length);
        if (png.substr(4, 4) == "iTXt") {
            // key, 0, not compressed, method 0, no language, 0, no translated key, 0, text
            const std::size_t key = data.find('\0');
            texts.push_back({std::string(data.substr(0, key)), std::string(data.substr(key + 5))});
        }
        png.remove_prefix(length + 12);
    }
    return texts;
}

std::string refusal(const std::string& file) {
    try {
        write_png(file, noise({2, 2}), {});
        return "written";
    } catch (const InputError& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("a picture that is written is read back as it was") {
    const Scratch scratch;
    for (const Resolution size : {Resolution{1, 1}, {3, 2}, {257, 5}, {1, 300}}) {
        const Image image = noise(size);
        write_png(scratch.file("a.png"), image, {});
        const Image back = read_png(scratch.file("a.png"));
        CHECK(back.resolution.width == size.width);
        CHECK(back.resolution.height == size.height);
        CHECK(back.pixels == image.pixels);
    }
    CHECK(scratch.count() == 1);
}

TEST_CASE("what a picture says of itself is in its text chunks, in UTF-8") {
    const Scratch scratch;
    const std::vector<PngText> texts = {
        {"Title", "été.rt"}, {"Software", "Raysteps step03_sphere"}, {"Options", ""}};
    write_png(scratch.file("a.png"), noise({2, 2}), texts);
    const std::vector<PngText> back = text_chunks(content(scratch.file("a.png")));
    REQUIRE(back.size() == texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        CHECK(back[i].key == texts[i].key);
        CHECK(back[i].value == texts[i].value);
    }
}

TEST_CASE("a picture makes its folders, and takes an older one's place") {
    const Scratch scratch;
    const std::string file = scratch.file("new/deep/a.png");
    write_png(file, noise({9, 9}), {});
    write_png(file, noise({3, 3}), {});
    CHECK(read_png(file).resolution.width == 3);
    CHECK(scratch.count() == 3);
}

TEST_CASE("a picture that cannot be written says why, and leaves nothing") {
    const Scratch scratch;
    fs::create_directory(scratch.file("folder.png"));
    write(scratch.file("file"), "as it was");
    const std::string no_folder = scratch.file("file") + ": error: cannot be made: ";
    CHECK(refusal(scratch.file("file/a.png")).starts_with(no_folder));
    CHECK(refusal(scratch.file("file/deep/a.png")).find(": error: ") != std::string::npos);
    CHECK(refusal(scratch.file("folder.png")) ==
          scratch.file("folder.png") +
              ": error: is a folder or a device: expected a name for the picture");
    CHECK_THROWS_AS(check_writable(scratch.file("folder.png")), InputError);
    CHECK_THROWS_AS(check_writable(scratch.file("file/a.png")), InputError);
    CHECK_NOTHROW(check_writable(scratch.file("file")));
    CHECK_NOTHROW(check_writable(scratch.file("a.png")));
    CHECK(content(scratch.file("file")) == "as it was");
    CHECK(scratch.count() == 2);
}

TEST_CASE("what is no PNG is refused by name") {
    const Scratch scratch;
    const std::string file = scratch.file("a.png");
    CHECK_THROWS_AS(read_png(file), InputError);
    write(file, "R 640 480\n");
    CHECK_THROWS_AS(read_png(file), InputError);
    write_png(file, noise({50, 50}), {});
    fs::resize_file(file, 1000);  // cut in the middle
    CHECK_THROWS_WITH(read_png(file), Catch::Matchers::StartsWith(file + ": error: "));
}
