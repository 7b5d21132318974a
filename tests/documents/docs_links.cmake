# Every link of a page leads to a file, and every name in backticks with a link to a header is in
# that header.
#
# cmake -DROOT=<project> -P docs_links.cmake

# Brackets and semicolons split a CMake list, so they are replaced.
string(ASCII 1 opening)
string(ASCII 2 closing)

file(GLOB pages ${ROOT}/README.md ${ROOT}/common/*/README.md ${ROOT}/docs/*.md ${ROOT}/docs/reference/*.md)
foreach(page IN LISTS pages)
    get_filename_component(folder ${page} DIRECTORY)
    file(READ ${page} text)
    string(REPLACE "[" "${opening}" text "${text}")
    string(REPLACE "]" "${closing}" text "${text}")
    string(REPLACE ";" "," text "${text}")

    string(REGEX MATCHALL "${closing}\\([^)]*\\)" links "${text}")
    foreach(link IN LISTS links)
        string(REGEX REPLACE "^.\\(([^#)]*).*" "\\1" target "${link}")
        if(NOT target STREQUAL "" AND NOT target MATCHES "^https?:" AND NOT EXISTS ${folder}/${target})
            message(SEND_ERROR "${page}: ${target} is not there")
        endif()
    endforeach()

    string(REGEX MATCHALL "${opening}`[A-Za-z0-9_]+`${closing}\\([^)]*[.]hpp\\)" names "${text}")
    foreach(name IN LISTS names)
        string(REGEX REPLACE "^.`([^`]*)`.\\((.*)\\)$" "\\2" target "${name}")
        string(REGEX REPLACE "^.`([^`]*)`.*" "\\1" name "${name}")
        if(EXISTS ${folder}/${target})
            file(READ ${folder}/${target} code)
            if(NOT code MATCHES "(^|[^A-Za-z0-9_])${name}([^A-Za-z0-9_]|$)")
                message(SEND_ERROR "${page}: ${name} is not in ${target}")
            endif()
        endif()
    endforeach()
endforeach()
