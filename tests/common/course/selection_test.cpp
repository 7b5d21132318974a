// What a lecturer leaves out of a hand-out.
#include "common/course/handout/selection.hpp"

#include "common/system/input_error.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

TEST_CASE("a hand-out may have a part of the stages, whose programs all stay") {
    Selection selection;
    CHECK(is_selected(selection, "docs/step13_meshes.md"));
    select_stages(selection, "2-8");
    for (const char* path :
         {"docs/step01_ray_generation.md", "docs/step09_phong.md", "steps/step13_meshes/hints.md",
          "steps/step10_shadows/starter/main.cpp"}) {
        INFO(path);
        CHECK_FALSE(is_selected(selection, path));
    }
    for (const char* path : {"docs/step02_camera_basis.md", "steps/step08_cone/hints.md",
                             "steps/step03_sphere/starter/sphere.cpp", "docs/errata.md",
                             "steps/step13_meshes/main.cpp", "steps/step09_phong/phong.hpp",
                             "scenes/step09_phong.rt", "docs/gallery/step09_phong.png"}) {
        INFO(path);
        CHECK(is_selected(selection, path));
    }
    select_stages(selection, "5");
    CHECK(selection.stages == std::set{5});
    select_stages(selection, "1-3,9,mirror");
    CHECK(selection.stages == std::set{1, 2, 3, 9, 12});
    for (const char* wrong :
         {"", "8-1", "0-3", "1-14", "1-", "-3", "1-8-9", "a", "1..8", "1-3,", "3,14"}) {
        INFO(wrong);
        CHECK_THROWS_AS(select_stages(selection, wrong), InputError);
    }
}

TEST_CASE("a hand-out may have a part of the hints, and no answers") {
    const std::string hints = "# Hints\n\n## 1\n\nA.\n\n## 2\n\nB.\n\n## 3\n\nC.\n";
    const std::string file = "steps/step03_sphere/hints.md";
    const auto with = [&](int levels) { return selected_text({.hints = levels}, file, hints); };
    CHECK(with(3) == hints);
    CHECK(with(2) == "# Hints\n\n## 1\n\nA.\n\n## 2\n\nB.\n");
    CHECK(with(1) == "# Hints\n\n## 1\n\nA.\n");
    CHECK(with(0) == "# Hints\n");
    const std::string page =
        "## Questions\n\n1. Why?\n\n<details><summary>Answers</summary>\n\n1. So.\n\n</details>\n"
        "\n<details><summary>For the curious</summary>\n\nMore.\n\n</details>\n";
    const std::string docs = "docs/step03_sphere.md";
    CHECK(selected_text({}, docs, page) == page);
    CHECK(selected_text({.answers = false}, docs, page) ==
          "## Questions\n\n1. Why?\n\n<details><summary>For the curious</summary>\n\nMore.\n\n"
          "</details>\n");
    CHECK(selected_text({.hints = 0}, docs, page) == page);
}

TEST_CASE("translations have no more than the page") {
    const std::string header = "msgid \"\"\nmsgstr \"\"\n\"Language: fr\\n\"\n";
    const std::string item =
        "#, no-wrap\nmsgid \"\"\n\"An item\\n\"\n\"of \\\"two\\\" lines.\\n\"\nmsgstr \"Deux "
        "lignes.\\n\"\n";
    const std::string answer = "#. type: Plain text\nmsgid \"So.\"\nmsgstr \"Parce que.\"\n";
    const std::string all = header + "\n" + item + "\n" + answer;
    CHECK(selected_entries(all, "- An item\n  of \"two\" lines.\n\n1. So.\n") == all);
    CHECK(selected_entries(all, "- An item\n  of \"two\" lines.\n") == header + "\n" + item);
    CHECK(selected_entries(all, "Nothing.\n") == header);
    CHECK(selected_entries(header + "\n#~ msgid \"So.\"\n#~ msgstr \"Parce que.\"\n", "So.\n") ==
          header);
}
