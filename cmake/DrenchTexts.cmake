# Text files that become part of a program.

# drench_embed_texts(VARIABLE BEFORE_TEXT AFTER_TEXT FILE...): appends each file's text as C++ to a variable, between two pieces
# of code in which <name> stands for the file's name without its ending. CMake runs again when a file changes.
function(drench_embed_texts variable before after)
  foreach(file ${ARGN})
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(name ${file} NAME_WE)
    file(READ ${path} text)
    string(REPLACE "<name>" ${name} start "${before}")
    string(APPEND ${variable} "${start}R\"text(${text})text\"${after}\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  endforeach()
  set(${variable} "${${variable}}" PARENT_SCOPE)
endfunction()
