# Writes to the file LABELS a script for ctest that gives each test case of PROGRAM its Catch tags
# as labels.
function(run_program result)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_VARIABLE output)
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

run_program(names --list-test-names-only)
run_program(tags --list-tags)
string(REGEX MATCHALL "\\[[^]\n]+\\]" tags "${tags}")
string(REGEX MATCHALL "[^\n]+" names "${names}")
foreach(tag IN LISTS tags)
  run_program(tagged ${tag} --list-test-names-only)
  string(REGEX MATCHALL "[^\n]+" tagged "${tagged}")
  string(REGEX REPLACE "[][]" "" label "${tag}")
  foreach(name IN LISTS tagged)
    string(MD5 key "${name}")
    list(APPEND labels_${key} ${label})
  endforeach()
endforeach()

set(script "")
foreach(name IN LISTS names)
  string(MD5 key "${name}")
  string(APPEND script
         "set_tests_properties([==[${name}]==] PROPERTIES LABELS \"${labels_${key}}\")\n")
endforeach()
file(WRITE ${LABELS} "${script}")
