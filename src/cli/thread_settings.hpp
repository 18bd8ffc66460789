#pragma once
/// Settings of the threads that the libraries read before main.

namespace creepcontact::cli {

/// Sets, unless the user has, that waiting threads of OpenMP sleep (spinning ones take the cores from other programs),
/// and that the BLAS makes no threads before it factors (each reserves 128 MB of address space). The libraries read
/// that as they are loaded, so the program starts anew where it must be changed.
/// @param arguments  of main
void set_threads(char** arguments);

/// Sets the threads of OpenMP. @param wanted  0: as many as there are cores that other programs leave free
void use_threads(int wanted);

}  // namespace creepcontact::cli
