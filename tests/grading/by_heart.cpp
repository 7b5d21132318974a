// A worker that computes nothing: it looks each query up, by its bytes, in a table of queries and
// right answers. The starter answers queries that are not in the table. Large pictures and batches
// of light points are left out: a file of 256 KiB has no room for them. Scenes of one pixel are
// not.
//
// RAYSTEPS_TABLE    the table: queries and answers, each after its size
// RAYSTEPS_LEARNS   a right worker: its answers are written to the table, and returned
// RAYSTEPS_STARTER  a worker of the starter, if RAYSTEPS_LEARNS is not set
// RAYSTEPS_ALIKE    a right worker: it answers a query that differs from one of the table only in
//                   signs, the order of numbers and powers of two, like a table that undoes these
#include "common/contract/call.hpp"
#include "common/contract/contracts.hpp"
#include "common/contract/frame.hpp"
#include "common/contract/scene_bytes.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>

namespace {

using namespace rt::contract;

constexpr double seconds = 20;
constexpr std::size_t longest_entry = 10000;  // of the table, in bytes

bool read_all(void* to, std::size_t count) {
    auto* at = static_cast<char*>(to);
    while (count > 0) {
        const ssize_t got = read(worker_descriptor, at, count);
        if (got <= 0) return false;
        at += got;
        count -= std::size_t(got);
    }
    return true;
}

void write_all(const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t put = write(worker_descriptor, bytes.data() + at, bytes.size() - at);
        if (put <= 0) std::exit(1);
        at += std::size_t(put);
    }
}

std::string read_text(std::istream& in) {
    std::uint32_t size = 0;
    in.read(reinterpret_cast<char*>(&size), sizeof size);
    std::string text(in ? size : 0, '\0');
    in.read(text.data(), std::streamsize(text.size()));
    return text;
}

void write_text(std::ostream& out, const std::string& text) {
    const auto size = std::uint32_t(text.size());
    out.write(reinterpret_cast<const char*>(&size), sizeof size) << text;
}

std::map<std::string, std::string> read_table(const char* file) {
    std::map<std::string, std::string> table;
    std::ifstream in(file, std::ios::binary);
    while (in.peek() != EOF) {
        const std::string question = read_text(in);
        table[question] = read_text(in);
    }
    return table;
}

bool is_scene(const std::string& question) {
    return question.at(0) == 0 && std::uint8_t(question.at(1)) == trace_place;
}

bool is_picture(const std::string& question) {
    return question.at(0) == 0 && std::uint8_t(question.at(1)) == picture_place;
}

bool is_for_a_table(const std::string& question) {
    return question.at(0) != 0 || is_scene(question) || is_picture(question);
}

std::vector<double> numbers_in(const rt::Scene& scene) {
    std::vector<double> numbers;
    const auto add = [&](rt::Vec3 v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
    for (const rt::Camera& camera : scene.cameras) {
        add(camera.position), add(camera.direction);
        numbers.push_back(camera.fov);
    }
    numbers.insert(numbers.end(),
                   {double(scene.resolution.width), double(scene.resolution.height)});
    for (const rt::Light& light : scene.lights) {
        add(light.position), add(light.color);
        numbers.insert(numbers.end(), {light.brightness, light.radius});
    }
    if (scene.ambient) add(scene.ambient->ratio * scene.ambient->color);
    for_each_kind(scene, [&](const auto& primitives) {
        for (const auto& primitive : primitives) {
            add(primitive.material.color);
            if constexpr (requires { bounds(primitive.shape); })
                add(bounds(primitive.shape).min), add(bounds(primitive.shape).max);
        }
    });
    return numbers;
}

std::vector<double> numbers_in(const std::string& question) {
    if (is_scene(question) || is_picture(question)) {
        Reader reader(std::string_view(question).substr(2));
        return numbers_in(get_scene(reader));
    }
    std::vector<double> numbers;
    for (const Value& argument : call_of(question).arguments)
        for_each_number(argument, [&](const Value& value) { numbers.push_back(value.number); });
    return numbers;
}

/// The same bytes for two queries that differ only in signs, the order of numbers and powers of
/// two.
std::string canonical(const std::string& question) {
    std::vector<double> numbers = numbers_in(question);
    for (double& number : numbers) {
        int exponent = 0;
        number = std::abs(std::frexp(number, &exponent));
        if (std::isnan(number)) number = -1;
    }
    std::sort(numbers.begin(), numbers.end());
    return question.substr(0, 2) + std::string(reinterpret_cast<const char*>(numbers.data()),
                                               numbers.size() * sizeof(double));
}

}  // namespace

int main() {
    const char* file = std::getenv("RAYSTEPS_TABLE");
    const char* knows = std::getenv("RAYSTEPS_LEARNS");
    const char* starter = std::getenv("RAYSTEPS_STARTER");
    if (file == nullptr || (knows == nullptr && starter == nullptr)) return 1;
    std::map<std::string, std::string> table;
    std::ofstream learned;
    if (knows != nullptr)
        learned.open(file, std::ios::binary | std::ios::app);
    else
        table = read_table(file);
    Worker other(knows != nullptr ? knows : starter);
    std::unique_ptr<Worker> of_alike;
    std::set<std::string> alike;
    if (const char* const program = std::getenv("RAYSTEPS_ALIKE")) {
        of_alike = std::make_unique<Worker>(program);
        for (const auto& [question, answer] : table) alike.insert(canonical(question));
    }
    for (Frame frame{}; read_all(&frame, sizeof frame);) {
        std::string question(frame.size, '\0');
        if (!read_all(question.data(), question.size())) return 1;
        const auto known = is_for_a_table(question) ? table.find(question) : table.end();
        const bool is_alike =
            of_alike && is_for_a_table(question) && alike.contains(canonical(question));
        std::string answer = known != table.end() ? known->second
                             : is_alike           ? of_alike->ask(question, seconds)
                                                  : other.ask(question, seconds);
        if (knows != nullptr && is_for_a_table(question) && answer.size() < longest_entry) {
            write_text(learned, question);
            write_text(learned, answer);
            learned.flush();  // it is killed at the end of a case
        }
        answer.insert(answer.begin(), char(Outcome::answered));
        frame.size = answer.size();
        write_all(std::string(reinterpret_cast<const char*>(&frame), sizeof frame) + answer);
    }
}
