// The bytes of files between two symbols each; CMakeLists.txt gives their paths.
        .section .rodata
#define ASSET(name, path) \
        .global creepcontact_##name##_begin; \
        .global creepcontact_##name##_end; \
        .balign 16; \
creepcontact_##name##_begin: .incbin path; \
creepcontact_##name##_end: .byte 0

ASSET(viewer_script, VIEWER_SCRIPT)
ASSET(viewer_style, VIEWER_STYLE)
ASSET(report_style, REPORT_STYLE)
ASSET(colours, COLOURS)
        .section .note.GNU-stack, "", %progbits
