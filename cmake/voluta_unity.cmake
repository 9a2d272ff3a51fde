# Unity builds: several sources of a target compiled as one, so that their headers are read once.
# A build from nothing is shorter, but an edit compiles the sources beside it too: packaging/ turns it
# on, development leaves it off.
option(VOLUTA_UNITY "Compile several sources of a target as one" OFF)
set(VOLUTA_UNITY_LINES 1800 CACHE STRING "Greatest number of lines that are compiled as one")

# Sets `names` to the names that `source` defines at file scope: what begins in the first column and is
# followed by a parameter list, a value or a body; and `count` to its lines. Members (A::b) do not count,
# nor do tests.
function(voluta_names_at_file_scope source names count)
  file(READ ${source} text)
  string(REPLACE "[[noreturn]] " "" text "${text}")
  string(REGEX REPLACE "[[]" "{" text "${text}") # a list of CMake takes no unpaired brackets
  string(REGEX REPLACE "[]]" "}" text "${text}")
  string(REPLACE ";" "@" text "${text}")
  string(REGEX MATCHALL "\n" lines "${text}")
  list(LENGTH lines lines)
  string(REGEX MATCHALL "\n([A-Za-z_]| +k[A-Z][A-Za-z0-9]* = )[^\n]*" starts "${text}")
  set(found)
  foreach(line IN LISTS starts)
    if(line MATCHES "^\n(using enum)")
      list(APPEND found ${CMAKE_MATCH_1})
    elseif(line MATCHES "^\n(namespace|using namespace|template|return|extern|TEST|TEST_F|TEST_P|INSTANTIATE)")
      # defines nothing
    elseif(line MATCHES "^\n(inline |static )?(constexpr|const) [^@(]*[={]|^\n +k") # one or several constants
      string(REGEX MATCHALL "[A-Za-z_][A-Za-z_0-9]*({[^}]*})? ?[={]" constants "${line}")
      list(TRANSFORM constants REPLACE "({[^}]*})? ?[={]" "")
      list(APPEND found ${constants})
    elseif(line MATCHES "^\n(struct|class|enum class|enum|union) ([A-Za-z_0-9]+)" OR
           line MATCHES "^\n(using) ([A-Za-z_0-9]+) =" OR
           line MATCHES "^\n([^(={@]*[ &*>])?([A-Za-z_0-9]+) ?[(={@]")
      list(APPEND found ${CMAKE_MATCH_2})
    endif()
  endforeach()
  set(${names} ${found} PARENT_SCOPE)
  set(${count} ${lines} PARENT_SCOPE)
endfunction()

# Spreads the sources of `target` over groups, in their order: each source goes into the first group
# that has room and defines none of its names. Two sources may thus have a helper of the same name in
# their unnamed namespaces. A source that is generated, has options of its own, or takes the names of an
# enumeration into its namespace (using enum) is compiled alone.
function(voluta_unity_target target)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set(groups 0)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder})
    get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
    if(NOT source MATCHES "\\.cpp$" OR NOT EXISTS ${source} OR source MATCHES "^${CMAKE_BINARY_DIR}" OR options)
      continue()
    endif()
    voluta_names_at_file_scope(${source} names count)
    if("using enum" IN_LIST names)
      continue()
    endif()
    set(chosen "")
    set(group 0)
    while(chosen STREQUAL "")
      if(group EQUAL groups)
        math(EXPR groups "${groups} + 1")
        set(names_${group} "")
        set(lines_${group} 0)
      endif()
      math(EXPR together "${lines_${group}} + ${count}")
      if(together LESS_EQUAL VOLUTA_UNITY_LINES OR lines_${group} EQUAL 0)
        set(chosen ${group})
        foreach(name IN LISTS names)
          if(name IN_LIST names_${group})
            set(chosen "")
            break()
          endif()
        endforeach()
      endif()
      math(EXPR group "${group} + 1")
    endwhile()
    list(APPEND names_${chosen} ${names})
    math(EXPR lines_${chosen} "${lines_${chosen}} + ${count}")
    set_source_files_properties(${source} TARGET_DIRECTORY ${target}
      PROPERTIES UNITY_GROUP ${target}_${chosen})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# All targets of `folder` and of the folders below it, but those that set UNITY_BUILD OFF. Call it behind the last target.
function(voluta_unity folder)
  if(NOT VOLUTA_UNITY)
    return()
  endif()
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(unity ${target} UNITY_BUILD)
    if(type MATCHES "^(STATIC_LIBRARY|EXECUTABLE)$" AND NOT unity STREQUAL "OFF")
      voluta_unity_target(${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    voluta_unity(${below})
  endforeach()
endfunction()
