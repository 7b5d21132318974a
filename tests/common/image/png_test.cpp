// Pictures as files.

#include "common/image/png.hpp"
#include "common/image/animation.hpp"
#include "common/system/input_error.hpp"

#include "tests/kit/for_all.hpp"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

/// An empty folder with the lifetime of this object.
class Scratch {
public:
    Scratch() : folder_("picture_of_test") {
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
    /// The number of files and folders in it, at any depth.
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

/// Type and content of each chunk of a PNG file, in order.
std::vector<PngText> chunks(std::string_view png) {
    std::vector<PngText> all;
    png.remove_prefix(8);  // the signature
    while (png.size() >= 12) {
        std::size_t length = 0;
        for (int i = 0; i < 4; ++i) length = length * 256 + std::uint8_t(png[std::size_t(i)]);
        all.push_back({std::string(png.substr(4, 4)), std::string(png.substr(8, length))});
        png.remove_prefix(length + 12);
    }
    return all;
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

TEST_CASE("a picture is compressed as it suits it, and is read back as it was") {
    const Scratch scratch;
    static constexpr Resolution size{320, 240};
    Random random(3);
    const auto draw = [](auto color) {
        Image image(size);
        for (Pixel p; p.row < size.height; ++p.row)
            for (p.column = 0; p.column < size.width; ++p.column) image[p] = color(p);
        return image;
    };
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    const Image tile = noise({16, 16});
    std::vector<std::uint8_t> shades(std::size_t(size.width));
    for (std::uint8_t& shade : shades) shade = byte(int(random.below(256)));
    const Image pictures[] = {
        draw([&](Pixel p) {
            return tile[{p.row % 16, p.column % 16}];
        }),
        draw([&](Pixel p) {
            return Rgb{byte(p.row + p.column), byte(2 * p.row + p.column), byte(p.row / 2)};
        }),
        draw([&](Pixel p) {
            return Rgb{byte(shades[std::size_t(p.column)] + p.row), 0, 0};
        }),
        // A ball that no row in the upper and lower quarters shows.
        draw([&](Pixel p) {
            const bool in = std::abs(p.row - 120) < 30 && std::abs(p.column - 160) < 30;
            return in ? Rgb{byte(3 * p.row + 5 * p.column), byte(p.row), 7} : Rgb{20, 30, 40};
        }),
    };
    // With no filter, or with one and Z_RLE, one of them takes more than a third.
    const std::size_t fiftieth = pictures[0].pixels.size() * 3 / 50;
    const std::string file = scratch.file("a.png");
    for (const Image& picture : pictures) {
        write_png(file, picture, {});
        CHECK(fs::file_size(file) < fiftieth);
        CHECK(read_png(file).pixels == picture.pixels);
        const std::string bytes = content(file);
        write_png(file, picture, {});
        CHECK(content(file) == bytes);
    }
}

TEST_CASE("a picture's settings are in its text chunks, in UTF-8") {
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

TEST_CASE("a picture says how its colors are encoded if that is given, and keeps its bytes") {
    const Scratch scratch;
    const std::string file = scratch.file("a.png");
    const Image image = noise({5, 4});
    const std::string full_light("gAMA\x00\x01\x86\xa0", 8);  // 100000, for an exponent of 1
    const auto has = [&](const std::string& text) {
        return content(file).find(text) != std::string::npos;
    };
    write_png(file, image, {});
    CHECK_FALSE(has("gAMA"));
    CHECK_FALSE(has("sRGB"));
    write_png(file, image, {}, Gamma::linear);
    CHECK(has(full_light));
    CHECK_FALSE(has("sRGB"));
    write_png(file, image, {}, Gamma::srgb);
    CHECK(has("sRGB"));
    CHECK_FALSE(has(full_light));
    CHECK(read_png(file).pixels == image.pixels);
}

TEST_CASE("a picture makes its folders, and takes an older one's place") {
    const Scratch scratch;
    const std::string file = scratch.file("new/deep/a.png");
    write_png(file, noise({9, 9}), {});
    write_png(file, noise({3, 3}), {});
    CHECK(read_png(file).resolution.width == 3);
    CHECK(scratch.count() == 3);
}

TEST_CASE("a picture that cannot be written is an error with a reason, and leaves nothing") {
    const Scratch scratch;
    fs::create_directory(scratch.file("folder.png"));
    write(scratch.file("file"), "as it was");
    const std::string no_folder = scratch.file("file") + ": error: cannot be made: ";
    CHECK(refusal(scratch.file("file/a.png")).starts_with(no_folder));
    CHECK(refusal(scratch.file("file/deep/a.png")).find(": error: ") != std::string::npos);
    CHECK(refusal(scratch.file("folder.png")) ==
          scratch.file("folder.png") +
              ": error: is not the name of a file: a picture is not written to a folder, a device, "
              "a pipe or the standard output");
    CHECK_THROWS_AS(check_writable(scratch.file("folder.png")), InputError);
    CHECK_THROWS_AS(check_writable(scratch.file("file/a.png")), InputError);
    CHECK_THROWS_AS(check_writable(scratch.file("file")), InputError);
    CHECK_NOTHROW(check_writable(scratch.file("a.png")));
    CHECK(content(scratch.file("file")) == "as it was");
    CHECK(scratch.count() == 2);
}

TEST_CASE("a picture replaces a picture, or an empty file, and nothing else") {
    const Scratch scratch;
    for (const std::string_view kept : {"R 640 480\n", "\x89PNG", "\x89PNG\r\n\x1a", " "}) {
        write(scratch.file("kept"), std::string(kept));
        CHECK(refusal(scratch.file("kept"))
                  .starts_with(scratch.file("kept") + ": error: exists and is not a PNG"));
        CHECK_THROWS_AS(check_writable(scratch.file("kept")), InputError);
        CHECK(content(scratch.file("kept")) == kept);
    }
    write(scratch.file("empty"), "");
    CHECK_NOTHROW(check_writable(scratch.file("empty")));
    CHECK(refusal(scratch.file("empty")) == "written");
    CHECK(refusal(scratch.file("empty")) == "written");  // a picture by now
    CHECK(scratch.count() == 2);
}

TEST_CASE("files beside a picture stay, whatever they are called") {
    const Scratch scratch;
    const std::vector<std::string> names = {"a.png.part", ".a.png.new", "a.png~",
                                            ".raysteps-.part"};
    for (const std::string& name : names) write(scratch.file(name), "mine");
    CHECK(refusal(scratch.file("a.png")) == "written");
    for (const std::string& name : names) CHECK(content(scratch.file(name)) == "mine");
    CHECK(std::size_t(scratch.count()) == names.size() + 1);
}

TEST_CASE("a place is checked without a trace") {
    const Scratch scratch;
    CHECK_NOTHROW(check_writable(scratch.file("new/deep/a.png")));
    CHECK(scratch.count() == 0);
}

TEST_CASE("a name as long as the system has them is fine") {
    const Scratch scratch;
    const std::string file = scratch.file(std::string(255, 'a'));
    CHECK(refusal(file) == "written");
    CHECK(read_png(file).resolution.width == 2);
}

TEST_CASE("a symbolic link is followed, and its target is written") {
    const Scratch scratch;
    fs::create_directory(scratch.file("folder"));
    std::error_code no_links;  // of a system, or a user
    fs::create_symlink("folder/a.png", scratch.file("link.png"), no_links);
    if (no_links) return;
    CHECK(refusal(scratch.file("link.png")) == "written");  // it leads to nothing yet
    CHECK(refusal(scratch.file("link.png")) == "written");
    CHECK(fs::is_symlink(scratch.file("link.png")));
    CHECK(read_png(scratch.file("folder/a.png")).resolution.width == 2);
    write(scratch.file("folder/source.cpp"), "int main() {}");
    fs::create_symlink("source.cpp", scratch.file("folder/other.png"));
    CHECK(refusal(scratch.file("folder/other.png")).find(": error: exists and is not a PNG") !=
          std::string::npos);
    CHECK(content(scratch.file("folder/source.cpp")) == "int main() {}");
    fs::create_symlink("round.png", scratch.file("round.png"));
    CHECK(refusal(scratch.file("round.png")).find(": error: ") != std::string::npos);
}

TEST_CASE("several writers of one picture each write a whole one") {
    const Scratch scratch;
    const std::string file = scratch.file("a.png");
    constexpr int writers = 8;
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (int i = 1; i <= writers; ++i)
        threads.emplace_back([&, i] {
            for (int turn = 0; turn < 20; ++turn) {
                write_png(file, noise({8 * i, 8 * i}), {});
                const Image back = read_png(file);  // another file
                const int side = back.resolution.width;
                if (back.pixels != noise({side, side}).pixels) ++wrong;
            }
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == 0);
    CHECK(scratch.count() == 1);
}

TEST_CASE("a file that is not a PNG is refused by name") {
    const Scratch scratch;
    const std::string file = scratch.file("a.png");
    CHECK_THROWS_AS(read_png(file), InputError);
    write(file, "R 640 480\n");
    CHECK_THROWS_AS(read_png(file), InputError);
    fs::remove(file);
    write_png(file, noise({50, 50}), {});
    fs::resize_file(file, 1000);  // cut in the middle
    CHECK_THROWS_WITH(read_png(file), Catch::Matchers::StartsWith(file + ": error: "));
}

TEST_CASE("an animation has every frame, and shows the first where animations are unknown") {
    const Scratch scratch;
    const Image first = noise({5, 3});
    const Image second(first.resolution);  // black
    Animation both;
    both.add(first);
    both.add(second);
    both.write(scratch.file("both.png"), 40, {{"Title", "both"}}, Gamma::srgb);
    CHECK(read_png(scratch.file("both.png")).pixels == first.pixels);

    Animation alone;
    alone.add(second);
    alone.write(scratch.file("alone.png"), 40, {}, Gamma::unstated);
    CHECK(read_png(scratch.file("alone.png")).pixels == second.pixels);

    const std::vector<PngText> all = chunks(content(scratch.file("both.png")));
    std::string types;
    for (const PngText& chunk : all) types += chunk.key + " ";
    REQUIRE(types == "IHDR sRGB acTL iTXt fcTL IDAT fcTL fdAT IEND ");
    using namespace std::string_literals;
    CHECK(all[2].value == "\0\0\0\2\0\0\0\0"s);  // two frames, without end
    // number, width, height, x, y, 40 of 1000 seconds, no disposal, no blending
    const std::string frame = "\0\0\0\5\0\0\0\3\0\0\0\0\0\0\0\0\0\50\3\350\0\0"s;
    CHECK(all[4].value == "\0\0\0\0"s + frame);
    CHECK(all[6].value == "\0\0\0\1"s + frame);
    // The second frame has the data that it has alone, after its number.
    CHECK(all[7].value == "\0\0\0\2"s + chunks(content(scratch.file("alone.png")))[3].value);
    CHECK(scratch.count() == 2);
}

TEST_CASE("an animation replaces pictures only") {
    const Scratch scratch;
    write(scratch.file("notes.txt"), "mine");
    Animation animation;
    animation.add(noise({2, 2}));
    CHECK_THROWS_AS(animation.write(scratch.file("notes.txt"), 40, {}, Gamma::unstated),
                    InputError);
    CHECK(content(scratch.file("notes.txt")) == "mine");
    CHECK(scratch.count() == 1);
}
