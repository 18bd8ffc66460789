// The bytes of picture.py between two symbols; CMakeLists.txt gives its path.
        .section .rodata
        .global creepcontact_picture_script_begin
        .global creepcontact_picture_script_end
        .balign 16
creepcontact_picture_script_begin: .incbin PICTURE_SCRIPT
creepcontact_picture_script_end: .byte 0
        .section .note.GNU-stack, "", %progbits
