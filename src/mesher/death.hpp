#pragma once
/// Last words of a process that ends before its work is done.

namespace creepcontact::mesher {

/// A line on standard error with the mesher's mark. Takes no memory: safe in signal handlers.
void report_line(const char* text);
/// The file and the line that Gmsh is reading, if it is reading one.
void report_place();

/// From here on until stop_watching(): whatever ends the process says where in the file Gmsh was. Exit in the file ends
/// it with the status `ended_by_file`.
void watch();
/// Gmsh has read the file: lines mean nothing any more.
void stop_reading();
/// Ends the process at once: the library's own clean-up is not worth its time.
[[noreturn]] void exit_at_once(int status);

}  // namespace creepcontact::mesher
