! A host in Fortran, without a window of its own.
module vides
    use, intrinsic :: iso_c_binding
    implicit none

    type, bind(c) :: v_punkt
        real(c_float) :: x, y, z
    end type

    type, bind(c) :: v_kamerapar
        type(v_punkt) :: vrp, vpn, vup
        integer(c_int) :: zoom
        type(c_ptr) :: prev, next
        integer(c_int) :: number
    end type

    interface
        subroutine v_haupt(move, orient, zoom, winkel, list, lines, object, rueck, ende) bind(c)
            import
            real(c_float), value :: move, orient, zoom, winkel
            type(v_kamerapar) :: list
            integer(c_int), value :: lines
            type(c_ptr), value :: object
            type(c_funptr), value :: rueck, ende
        end subroutine

        integer(c_int) function v_main_loop() bind(c)
            import
        end function
    end interface

contains

    subroutine rueck(poses, count) bind(c)
        type(v_kamerapar) :: poses
        integer(c_int), value :: count

        print '(i0, a)', count, ' poses'
        flush (6)
    end subroutine
end module

program host
    use vides
    implicit none

    type(v_kamerapar), target, save :: list
    type(v_kamerapar), pointer :: pose
    integer :: n

    list%number = -1 ! no poses yet
    call v_haupt(100.0, 100.0, 100.0, 100.0, list, 0, c_null_ptr, c_funloc(rueck), c_null_funptr)
    if (v_main_loop() /= 0) stop 1
    if (list%number < 0) stop
    pose => list
    do n = 1, 2 ! the first, and its predecessor in the ring: the last
        print '(i0, a, 3f8.4)', pose%number, ': ', pose%vrp%x, pose%vrp%y, pose%vrp%z
        call c_f_pointer(pose%prev, pose)
    end do
end program
