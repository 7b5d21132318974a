// Answers queries with the functions that it is linked to: a student's file, the reference, or a
// known mistake.
#include "common/contract/contracts.hpp"
#include "common/contract/frame.hpp"
#include "common/contract/light_points.hpp"
#include "common/contract/rendered.hpp"
#include "common/contract/scene_bytes.hpp"
#include "common/system/end_with_parent.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <map>

namespace rt::contract {

namespace {

using Answer = void (*)(Reader& question, Writer& answer);

void answer_with_picture(Reader& question, Writer& answer) {
    const Scene scene = get_scene(question);
    const auto settings = get<RenderSettings>(question);
    const int every = get<int>(question);
    question.end();
    const auto [width, height] = scene.resolution;
    if (scene.cameras.empty() || width < 1 || height < 1 || width > largest_side ||
        height > largest_side || every < 1)
        throw Malformed("no picture");
    put(answer, rendered(scene, settings, every).pixels);
}

void answer_with_color(Reader& question, Writer& answer) {
    const Scene scene = get_scene(question);
    const auto settings = get<RenderSettings>(question);
    question.end();
    if (scene.cameras.empty()) throw Malformed("no camera");
    put(answer, traced(scene, settings));
}

void answer_with_light_points(Reader& question, Writer& answer) {
    const auto light = get<Light>(question);
    const auto from = get<Vec3>(question);
    const auto seed = get<std::uint32_t>(question);
    const int count = get<int>(question);
    question.end();
    if (count < 0 || count > 65536) throw Malformed("too many points");
    put(answer, light_points(light, from, seed, count));
}

std::map<int, Answer> all_answers() {
    std::map<int, Answer> answers;
    std::array<int, stage_count + 1> places{};
    for_each_function([&]<class F>(int stage, F) {
        answers[stage << 8 | places.at(std::size_t(stage))++] = F::answer;
    });
    answers[picture_place] = answer_with_picture;
    answers[light_points_place] = answer_with_light_points;
    answers[trace_place] = answer_with_color;
    return answers;
}

/// The input, read in the largest available blocks.
class Inbox {
public:
    /// False if the input ended first.
    bool read(char* to, std::size_t count) {
        while (count > 0) {
            if (from_ == to_ && !fill()) return false;
            const std::size_t piece = std::min(count, to_ - from_);
            std::memcpy(to, buffer_.data() + from_, piece);
            from_ += piece;
            to += piece;
            count -= piece;
        }
        return true;
    }

    /// True if there is more input.
    bool goes_on() { return from_ < to_ || fill(); }

private:
    bool fill() {
        const ssize_t got = ::read(worker_descriptor, buffer_.data(), buffer_.size());
        from_ = 0;
        to_ = got > 0 ? std::size_t(got) : 0;
        return to_ > 0;
    }

    std::array<char, 1 << 16> buffer_;
    std::size_t from_ = 0;
    std::size_t to_ = 0;
};

bool write_all(const char* from, std::size_t count) {
    while (count > 0) {
        const ssize_t put = write(worker_descriptor, from, count);
        if (put <= 0) return false;
        from += put;
        count -= std::size_t(put);
    }
    return true;
}

/// Reads in blocks: a size that promises more than the input contains costs no memory.
bool read_question(Inbox& inbox, std::string& question, std::size_t size) {
    constexpr std::size_t piece = std::size_t(1) << 20;
    question.clear();
    while (question.size() < size) {
        const std::size_t before = question.size();
        question.resize(std::min(size, before + piece));
        if (!inbox.read(question.data() + before, question.size() - before)) return false;
    }
    return true;
}

Writer answer_to(const std::string& question, const std::map<int, Answer>& answers) {
    Reader reader(question);
    const auto [stage, place] = get<Number>(reader);
    const auto answer = answers.find(stage << 8 | place);
    if (answer == answers.end()) throw Malformed("no such function");
    Writer writer;
    try {
        put(writer, Outcome::answered);
        answer->second(reader, writer);
    } catch (const Malformed&) {
        throw;
    } catch (const std::exception& exception) {
        writer = {};
        put(writer, Outcome::thrown);
        writer.raw(exception.what(), strnlen(exception.what(), longest_words));
    } catch (...) {
        writer = {};
        put(writer, Outcome::thrown);
    }
    return writer;
}

int serve() {
    end_with_parent(SIGKILL);  // a worker without a client must not go on
    const std::map<int, Answer> answers = all_answers();
    Inbox inbox;
    std::string question;
    Frame frame{};
    // A last frame that is cut short is malformed, its absence is not.
    while (inbox.goes_on()) {
        if (!inbox.read(reinterpret_cast<char*>(&frame), sizeof frame) ||
            frame.size > largest_question || !read_question(inbox, question, frame.size))
            throw Malformed("a truncated frame");
        const Writer answer = answer_to(question, answers);
        frame.size = answer.bytes().size();
        std::string bytes(reinterpret_cast<const char*>(&frame), sizeof frame);
        bytes += answer.bytes();
        if (!write_all(bytes.data(), bytes.size())) return 1;
    }
    return 0;
}

}  // namespace

}  // namespace rt::contract

int main() {
    try {
        return rt::contract::serve();
    } catch (const rt::contract::Malformed&) {
        return rt::contract::malformed_status;
    }
}
