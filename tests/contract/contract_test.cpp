// Values as bytes and as text, workers that get invalid queries, and the smallest failing call.
#include "common/contract/call.hpp"
#include "common/contract/contracts.hpp"
#include "common/contract/difference_texts.hpp"
#include "common/contract/frame.hpp"
#include "common/contract/probes.hpp"
#include "common/contract/recognition.hpp"
#include "common/contract/smallest.hpp"

#include "tests/kit/catch.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

using namespace rt;
using namespace rt::contract;

namespace {

template <class T>
std::string bytes_of(const T& value) {
    Writer writer;
    put(writer, value);
    return writer.bytes();
}

/// The same bits again, as bytes and, through text, as a tree.
template <class T>
bool comes_back(const T& value) {
    const std::string bytes = bytes_of(value);
    Reader reader(bytes);
    const T again = get<T>(reader);
    reader.end();
    Reader tree_reader(bytes);
    const Value tree = get_value(type_of<T>(), tree_reader);
    Writer writer;
    put_value(writer, tree);
    const std::string text = code(tree);
    std::string_view rest = text;
    Writer from_text;
    put_value(from_text, read_value(type_of<T>(), rest));
    return bytes_of(again) == bytes && writer.bytes() == bytes && rest.empty() &&
           from_text.bytes() == bytes;
}

template <class T>
bool refused(const std::string& bytes) {
    try {
        Reader reader(bytes);
        get<T>(reader);
        reader.end();
        return false;
    } catch (const Malformed&) {
        return true;
    }
}

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// A worker that receives damaged or hostile bytes.
class Attacked {
public:
    explicit Attacked(const std::string& program) {
        int sockets[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) std::abort();
        process_ = fork();
        if (process_ == 0) {
            dup2(sockets[1], worker_descriptor);
            execl(program.c_str(), program.c_str(), nullptr);
            _exit(127);
        }
        close(sockets[1]);
        socket_ = sockets[0];
    }

    void write(const std::string& bytes) const {
        CHECK(send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == ssize_t(bytes.size()));
    }

    /// Its exit status, once there is nothing more to read.
    [[nodiscard]] int status() const {
        shutdown(socket_, SHUT_WR);
        int status = 0;
        waitpid(process_, &status, 0);
        close(socket_);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t process_ = 0;
    int socket_ = -1;
};

int status_after(const std::string& bytes) {
    const Attacked worker(RAYSTEPS_REFERENCE_WORKER);
    worker.write(bytes);
    return worker.status();
}

std::string frame(const std::string& question) {
    const contract::Frame head{.size = question.size(), .ticket = 7};
    return std::string(reinterpret_cast<const char*>(&head), sizeof head) + question;
}

Call call_of_sphere(const Ray& ray, const Sphere& sphere) {
    return call_of(bytes_of(Number{.stage = 3, .place = 0}) + bytes_of(ray) + bytes_of(sphere) +
                   bytes_of(Interval{}));
}

const Ray ahead{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
const Sphere unit_sphere{.center = {0, 0, 0}, .radius = 1};

/// The diagnosis of a program in wrong/.
struct Diagnosis {
    std::vector<Recognized> mistakes;
    std::optional<Difference> smallest;
};

Diagnosis diagnosis(const std::string& wrong) {
    const Probes probes = read_probes(content_of(RAYSTEPS_PROBES));
    Asked student(std::string(RAYSTEPS_WRONG) + "/" + wrong);
    Asked reference(RAYSTEPS_REFERENCE_WORKER);
    std::vector<Call> calls;
    for (const Probe& probe : probes.probes) calls.push_back(probe.call);
    const auto answers = student(calls);
    return {.mistakes = recognized(probes, answers, {}),
            .smallest = smallest_difference(probes, answers, student, reference)};
}

/// No number of the call has more than a digit and a sign.
bool is_round(const Call& call) {
    bool round = true;
    for (const Value& argument : call.arguments)
        for_each_number(argument, [&](const Value& value) {
            const double twice = 2 * std::abs(value.number);
            round = round && (std::isinf(twice) || (twice == std::floor(twice) && twice < 20));
        });
    return round;
}

}  // namespace

TEST_CASE("values are read back as the same bits, from bytes and from text") {
    CHECK(comes_back(ahead));
    CHECK(comes_back(Ray{.origin = {not_a_number, Real(-0.0), Real(0.1)},
                         .direction = {infinity, -infinity, Real(5e-324)}}));
    CHECK(comes_back(Interval{}));
    CHECK(comes_back(Square{.side = Real(0.3), .one_sided = true}));
    CHECK(comes_back(OrientedBox{}));
    CHECK(comes_back(Cone{.axis = {0, 0, -1}, .radius = Real(1) / 3}));
    CHECK(comes_back(Transform{.scale = 2, .translation = {1, 2, 3}}));
    CHECK(comes_back(ShadingPoint{.error = Real(1e-17), .material = {.color = {1, 0, Real(0.5)}}}));
    CHECK(comes_back(ShadowRay{.ray = ahead, .interval = {.min = 0, .max = 1}}));
    CHECK(comes_back(ShadowRays{.sent = 16, .reached = 3}));
    CHECK(comes_back(Mat4(Real(0.25))));
    CHECK(comes_back(std::array<Vec3, 3>{Vec3(1), Vec3(2), Vec3(3)}));
    CHECK(comes_back(std::optional<Real>()));
    CHECK(comes_back(std::optional<Real>(Real(-0.0))));
    CHECK(comes_back(std::optional<Interval>(Interval{})));
    CHECK(comes_back(std::optional<MeshHit>(MeshHit{.t = 1, .triangle = 4294967295U})));
    CHECK(comes_back(Pixel{.row = -1, .column = 2147483647}));
    CHECK(comes_back(true));
}

TEST_CASE("a mesh is read back, empty or of a hundred thousand vertices") {
    CHECK(comes_back(Mesh{}));
    Mesh mesh;
    for (std::uint32_t i = 0; i < 100000; ++i) {
        mesh.vertices.emplace_back(Real(i), Real(i) / 3, -Real(i));
        mesh.triangles.push_back({i, 0, 100000 - i});
    }
    CHECK(comes_back(mesh));
}

TEST_CASE("bytes that are not a value are refused") {
    const std::string bytes = bytes_of(ahead);
    CHECK(refused<Ray>(bytes.substr(1)));
    CHECK(refused<Ray>(bytes + '\0'));
    CHECK(refused<Ray>(""));
    CHECK(refused<bool>("\2"));
    CHECK(refused<std::optional<Real>>("\1"));
    // as many vertices as the size allows, but no data
    CHECK(refused<Mesh>(std::string(4, '\xff')));
}

TEST_CASE("a worker ends with a special status after a malformed query") {
    const std::string question = question_of(call_of_sphere(ahead, unit_sphere));
    CHECK(status_after("") == 0);
    CHECK(status_after(frame(question)) == 0);
    CHECK(status_after(frame(question).substr(0, 5)) == malformed_status);
    CHECK(status_after(frame(question).substr(0, 30)) == malformed_status);
    CHECK(status_after(frame(question.substr(0, 30))) == malformed_status);
    CHECK(status_after(frame(question + "more")) == malformed_status);
    CHECK(status_after(frame("")) == malformed_status);
    CHECK(status_after(frame("\3\144")) == malformed_status);  // no such function
    CHECK(status_after(frame("\143\1")) == malformed_status);  // no such stage
    CHECK(status_after(std::string(16, '\xff')) == malformed_status);
    CHECK(status_after(frame(bytes_of(Number{.stage = 0, .place = 255}))) == malformed_status);
}

TEST_CASE("a worker's answer, or the reason why there is none") {
    const Call call = call_of_sphere(ahead, unit_sphere);
    const Call to_the_right =
        call_of_sphere(Ray{.origin = {-5, 0, 0}, .direction = {1, 0, 0}}, unit_sphere);
    const Call beside =
        call_of_sphere(Ray{.origin = {9, 0, 0}, .direction = {0, 1, 0}}, unit_sphere);
    const std::string wrong = RAYSTEPS_WRONG;
    CHECK(code(Asked(RAYSTEPS_REFERENCE_WORKER)(call)) == "4");
    CHECK(code(Asked(RAYSTEPS_REFERENCE_WORKER)(beside)) == "std::nullopt");
    CHECK(Asked(wrong + "/crashes")(to_the_right).failure == "crashed: Aborted");
    CHECK(Asked(wrong + "/never_answers")(call).failure == "gave no answer within 1 s");
    CHECK(Asked(wrong + "/waits_in_the_kernel")(call).failure == "gave no answer within 1 s");
    CHECK(Asked(wrong + "/throws")(beside).failure == "threw an exception: bad optional access");
    CHECK_THROWS_AS(Asked(wrong + "/not_there")(call), CannotStart);
}

TEST_CASE("sleep counts while it is looked at, and not while the one that looks is stopped") {
    const pid_t sleeper = fork();
    if (sleeper == 0)
        for (;;) pause();
    Stopwatch stopwatch(sleeper);
    (void)stopwatch.waits();
    for (int i = 0; i < 50; ++i) {
        usleep(20000);
        stopwatch.look();
    }
    const double looked_at = stopwatch.used();
    CHECK(looked_at > 0.5);  // a second, and less on a busy machine
    usleep(2000000);
    stopwatch.look();
    CHECK(stopwatch.used() - looked_at < 0.5);
    kill(sleeper, SIGKILL);
    waitpid(sleeper, nullptr, 0);
}

TEST_CASE("a worker is restarted after a crash, but not after a timeout") {
    const Call ahead_call = call_of_sphere(ahead, unit_sphere);
    const Call to_the_right =
        call_of_sphere(Ray{.origin = {-5, 0, 0}, .direction = {1, 0, 0}}, unit_sphere);
    Asked crashes(std::string(RAYSTEPS_WRONG) + "/crashes");
    CHECK(code(crashes(to_the_right)) == "crashed");
    CHECK(code(crashes(ahead_call)) == "4");
    Asked hangs(std::string(RAYSTEPS_WRONG) + "/never_answers");
    CHECK(hangs(ahead_call).asked());
    CHECK_FALSE(hangs(ahead_call).asked());
}

TEST_CASE("an unknown mistake is shown by a call with round numbers") {
    for (const char* const wrong : {"too_large", "flattened", "throws"}) {
        const Diagnosis found = diagnosis(wrong);
        INFO(wrong);
        CHECK(found.mistakes.empty());
        REQUIRE(found.smallest);
        INFO(code(found.smallest->call));
        CHECK(is_round(found.smallest->call));
    }
}

TEST_CASE("the calls of a report's failures are read, and other questions are not") {
    const std::vector<Call> calls = failing_calls(
        3,
        "cases 4\ncase a\npart intersect\nat tests/a.cpp:1\n"
        "| intersect(Ray{.origin = {0, 0, 5}, .direction = {0, 0, Real(-0.5)}},\n"
        "|           Sphere{.center = {0, 0, 0}, .radius = 2})\n|   got:      no hit\n"
        "|   expected: a hit at t = 3\n|   paste:    CHECK(hits(1, 2));\nfailed\n"
        "case b\npassed\ncase c\n| its origin\n|   got:      1\nfailed\n"
        "case d\n| torch({1, 2, 3}, {0, 0, 1}, {0, 0, 4})\n|   got:      NaN\nfailed\n");
    REQUIRE(calls.size() == 2);
    CHECK(code(calls[0]) ==
          "intersect(Ray{.origin = {0, 0, 5}, .direction = {0, 0, Real(-0.5)}}, Sphere{.center = "
          "{0, 0, 0}, .radius = 2}, Interval{.min = 0, .max = infinity})");
    CHECK(code(calls[1]) == "torch({1, 2, 3}, {0, 0, 1}, {0, 0, 4})");
}

TEST_CASE("the smallest call that crashes does crash") {
    const Diagnosis found = diagnosis("crashes");
    REQUIRE(found.smallest);
    CHECK(found.smallest->call.arguments[0].parts[1].parts[0].number > 0.25);
    CHECK(answer_text(found.smallest->call, found.smallest->got) == "your code crashed: Aborted");
}

TEST_CASE("an endless loop is diagnosed") {
    const Diagnosis found = diagnosis("never_answers");
    REQUIRE(found.smallest);
    CHECK(answer_text(found.smallest->call, found.smallest->got) ==
          "your code gave no answer within 1 s");
}

TEST_CASE("a failing call is a line to paste") {
    const Call call = call_of_sphere(ahead, unit_sphere);
    const Value hit = *Asked(RAYSTEPS_REFERENCE_WORKER)(call).value;
    CHECK(paste_line(call, hit) ==
          "CHECK(hits(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, "
          "Sphere{.center = {0, 0, 0}, .radius = 1}, 4));");
    CHECK(paste_line(call, Value{.type = hit.type}) ==
          "CHECK(misses(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, "
          "Sphere{.center = {0, 0, 0}, .radius = 1}));");
    CHECK(paste_line(read_call(9, "reflected({0, 0, 1}, {0, 0, 1})"),
                     Asked(RAYSTEPS_REFERENCE_WORKER)(read_call(3, "color_from_normal({0, 0, 1})"))
                         .value.value()) ==
          "CHECK(gives(\"reflected\", reflected({0, 0, 1}, {0, 0, 1}), Vec3{0, 0, 1}));");
}

TEST_CASE("an answer of several parts is one call in a line to paste, without the sign of a zero") {
    const Call call = read_call(2, "orthonormal_basis({0, 0, 1})");
    const Basis basis{.x = {1, 0, Real(-0.0)}, .y = {0, 1, 0}, .z = {0, 0, 1}};
    const std::string bytes = bytes_of(basis);
    Reader reader(bytes);
    CHECK(paste_line(call, get_value(type_of<Basis>(), reader)) ==
          "{\n    const auto answer = orthonormal_basis({0, 0, 1});\n"
          "    CHECK(gives(\"answer.x\", answer.x, Vec3{1, 0, 0}));\n"
          "    CHECK(gives(\"answer.y\", answer.y, Vec3{0, 1, 0}));\n"
          "    CHECK(gives(\"answer.z\", answer.z, Vec3{0, 0, 1}));\n}");
}

TEST_CASE("a slice shows the shape's section, the ray and both hits") {
    const Diagnosis found = diagnosis("too_large");
    REQUIRE(found.smallest);
    Asked reference(RAYSTEPS_REFERENCE_WORKER);
    const std::string svg = slice(*found.smallest, reference);
    CHECK(svg.find("expected: t = ") != std::string::npos);
    CHECK(svg.find("yours: ") != std::string::npos);
    CHECK(std::ranges::count(svg, '\n') > 200);
}

TEST_CASE("a slice without an answer, or with one that is not a number, has a fixed text") {
    const Call call = call_of_sphere(ahead, unit_sphere);
    Asked reference(RAYSTEPS_REFERENCE_WORKER);
    Difference difference{.call = call, .expected = reference(call)};
    difference.got = {.failure = "threw an exception: <b>"};
    const std::string threw = slice(difference, reference);
    CHECK(threw.find("\nyours: no answer\n") != std::string::npos);
    CHECK(threw.find("no hit") == std::string::npos);
    difference.got = difference.expected;
    difference.got.value->parts.front().number = std::nan("");
    CHECK(slice(difference, reference).find("yours: no hit") == std::string::npos);
}
