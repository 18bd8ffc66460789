#pragma once
/// How idle OpenMP threads wait.

namespace creepcontact::cli {

/// Makes threads that wait for each other sleep rather than spin: on a busy machine spinning ones take the processor
/// from those they wait for (measured: six times the run time). libgomp reads this from its environment before main()
/// alone, so the program starts itself anew once; a choice that the user made in the environment stays.
void let_waiting_threads_sleep(char** arguments);

}  // namespace creepcontact::cli
