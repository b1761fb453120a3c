; The module of one fused loop, and the functions it calls; llvm_ir.py fills in what has a dollar sign.
;
; The functions are branchless, with sines and arctangents as polynomials, so that the compiler computes several
; positions at once. Coefficients are those of fdlibm (Sun Microsystems, 1993), correct to within one unit of the last
; place, here by their bits, the highest power first.

declare double @llvm.sqrt.f64(double)
declare double @llvm.fabs.f64(double)
declare double @llvm.floor.f64(double)
declare double @llvm.copysign.f64(double, double)
declare double @llvm.fma.f64(double, double, double)

; the root, of a negative number zero
define internal double @ksqrt(double %x) alwaysinline {
  %below = fcmp olt double %x, 0.0
  %kept = select i1 %below, double 0.0, double %x
  %root = call double @llvm.sqrt.f64(double %kept)
  ret double %root
}

define internal double @khypot(double %x, double %y) alwaysinline {
  %xx = fmul double %x, %x
  %yy = fmul double %y, %y
  %sum = fadd double %xx, %yy
  %root = call double @llvm.sqrt.f64(double %sum)
  ret double %root
}

define internal double @kmax(double %x, double %y) alwaysinline {
  %more = fcmp ugt double %x, %y
  %one = select i1 %more, double %x, double %y
  ret double %one
}

define internal double @kmin(double %x, double %y) alwaysinline {
  %less = fcmp ult double %x, %y
  %one = select i1 %less, double %x, double %y
  ret double %one
}

; a step of Horner's rule
define internal double @kstep(double %sum, double %z, double %coefficient) alwaysinline {
  %product = fmul contract double %sum, %z
  %next = fadd contract double %product, %coefficient
  ret double %next
}

; x + x³·(polynomial in x²)
define internal double @ksin(double %x) alwaysinline {
  %z = fmul double %x, %x
  %cube = fmul double %z, %x
  %p4 = call double @kstep(double 0x3DE5D93A5ACFD57C, double %z, double 0xBE5AE5E68A2B9CEB)
  %p3 = call double @kstep(double %p4, double %z, double 0x3EC71DE357B1FE7D)
  %p2 = call double @kstep(double %p3, double %z, double 0xBF2A01A019C161D5)
  %p1 = call double @kstep(double %p2, double %z, double 0x3F8111111110F8A6)
  %p0 = call double @kstep(double %p1, double %z, double 0xBFC5555555555549)
  %rest = fmul contract double %cube, %p0
  %sine = fadd contract double %x, %rest
  ret double %sine
}

; 1 - x²/2, with its rounding error, + x⁴·(polynomial in x²)
define internal double @kcos(double %x) alwaysinline {
  %z = fmul double %x, %x
  %half = fmul double %z, 0.5
  %zz = fmul double %z, %z
  %p4 = call double @kstep(double 0xBDA8FAE9BE8838D4, double %z, double 0x3E21EE9EBDB4B1C4)
  %p3 = call double @kstep(double %p4, double %z, double 0xBE927E4F809C52AD)
  %p2 = call double @kstep(double %p3, double %z, double 0x3EFA01A019CB1590)
  %p1 = call double @kstep(double %p2, double %z, double 0xBF56C16C16C15177)
  %p0 = call double @kstep(double %p1, double %z, double 0x3FA555555555554C)
  %rest = fmul double %zz, %p0
  %rounded = fsub double 1.0, %half
  %kept = fsub double 1.0, %rounded
  %lost = fsub double %kept, %half
  %small = fadd double %lost, %rest
  %cosine = fadd double %rounded, %small
  ret double %cosine
}

; an angle less than a right or straight one by this much: both parts of that angle
define internal double @kless(double %high, double %low, double %angle) alwaysinline {
  %less = fsub double %angle, %low
  %rest = fsub double %high, %less
  ret double %rest
}

; from 0, arctan ½ or 45°, whichever is near, by a polynomial in the tangent of the rest
define internal double @katan2(double %y, double %x) alwaysinline {
  %ax = call double @llvm.fabs.f64(double %x)
  %ay = call double @llvm.fabs.f64(double %y)
  %steep = fcmp ogt double %ay, %ax
  %low = select i1 %steep, double %ax, double %ay
  %most = select i1 %steep, double %ay, double %ax
  %nothing = fcmp oeq double %most, 0.0
  %high = select i1 %nothing, double 1.0, double %most
  %first = fmul double %high, 0.4375
  %small = fcmp olt double %low, %first
  %second = fmul double %high, 0.6875
  %middle = fcmp olt double %low, %second
  %two_low = fadd double %low, %low
  %two_high = fadd double %high, %high
  %top_half = fsub double %two_low, %high
  %top_one = fsub double %low, %high
  %top_far = select i1 %middle, double %top_half, double %top_one
  %top = select i1 %small, double %low, double %top_far
  %under_half = fadd double %two_high, %low
  %under_one = fadd double %low, %high
  %under_far = select i1 %middle, double %under_half, double %under_one
  %under = select i1 %small, double %high, double %under_far
  %a = fdiv double %top, %under
  %z = fmul double %a, %a
  %p9 = call double @kstep(double 0x3F90AD3AE322DA11, double %z, double 0xBFA2B4442C6A6C2F)
  %p8 = call double @kstep(double %p9, double %z, double 0x3FA97B4B24760DEB)
  %p7 = call double @kstep(double %p8, double %z, double 0xBFADDE2D52DEFD9A)
  %p6 = call double @kstep(double %p7, double %z, double 0x3FB10D66A0D03D51)
  %p5 = call double @kstep(double %p6, double %z, double 0xBFB3B0F2AF749A6D)
  %p4 = call double @kstep(double %p5, double %z, double 0x3FB745CDC54C206E)
  %p3 = call double @kstep(double %p4, double %z, double 0xBFBC71C6FE231671)
  %p2 = call double @kstep(double %p3, double %z, double 0x3FC24924920083FF)
  %p1 = call double @kstep(double %p2, double %z, double 0xBFC999999998EBC4)
  %p0 = call double @kstep(double %p1, double %z, double 0x3FD555555555550D)
  %zp = fmul double %z, %p0
  %lost = fmul double %a, %zp
  %base_far = select i1 %middle, double 0x3FDDAC670561BB4F, double 0x3FE921FB54442D18
  %base = select i1 %small, double 0.0, double %base_far
  %fine_far = select i1 %middle, double 0x3C7A2B7F222F65E2, double 0x3C81A62633145C07
  %fine = select i1 %small, double 0.0, double %fine_far
  %less = fsub double %lost, %fine
  %rest = fsub double %less, %a
  %flat = fsub double %base, %rest
  %upright = call double @kless(double 0x3FF921FB54442D18, double 0x3C91A62633145C07, double %flat)
  %ahead = select i1 %steep, double %upright, double %flat
  %back = fcmp olt double %x, 0.0
  %behind = call double @kless(double 0x400921FB54442D18, double 0x3CA1A62633145C07, double %ahead)
  %angle = select i1 %back, double %behind, double %ahead
  %signed = call double @llvm.copysign.f64(double %angle, double %y)
  ret double %signed
}

; the rounding error of a - b
define internal double @klost(double %a, double %b) alwaysinline {
  %difference = fsub double %a, %b
  %part = fsub double %difference, %a
  %rest = fsub double %difference, %part
  %of_a = fsub double %a, %rest
  %of_b = fadd double %b, %part
  %lost = fsub double %of_a, %of_b
  ret double %lost
}

; the rounding error of the square of a - b, that of the difference included
define internal double @ksquare(double %a, double %b) alwaysinline {
  %difference = fsub double %a, %b
  %lost = call double @klost(double %a, double %b)
  %square = fmul double %difference, %difference
  %twice = fadd double %lost, %lost
  %less = fneg double %square
  %rounded = call double @llvm.fma.f64(double %difference, double %difference, double %less)
  %both = call double @llvm.fma.f64(double %difference, double %twice, double %rounded)
  ret double %both
}

; planes.geometry.arithmetic.gap, with the rounding errors of products by one fused operation: (r + s)² less the square
; of the distance, two parts of each, so that gaps of the same places share the latter
define internal double @kgap(double %cx, double %cy, double %dx, double %dy, double %r, double %s) alwaysinline {
  %x = fsub double %dx, %cx
  %y = fsub double %dy, %cy
  %back = fneg double %s
  %reach = fsub double %r, %back
  %xx = fmul double %x, %x
  %yy = fmul double %y, %y
  %reach2 = fmul double %reach, %reach
  %x_lost = call double @ksquare(double %dx, double %cx)
  %y_lost = call double @ksquare(double %dy, double %cy)
  %reach_lost = call double @ksquare(double %r, double %back)
  %yy_less = fneg double %yy
  %distance2 = fsub double %xx, %yy_less
  %part = call double @klost(double %xx, double %yy_less)
  %both_lost = fadd double %x_lost, %y_lost
  %lost = fadd double %part, %both_lost
  %large = fsub double %reach2, %distance2
  %small = fsub double %reach_lost, %lost
  %left = fadd double %large, %small
  %acx = call double @llvm.fabs.f64(double %cx)
  %acy = call double @llvm.fabs.f64(double %cy)
  %adx = call double @llvm.fabs.f64(double %dx)
  %ady = call double @llvm.fabs.f64(double %dy)
  %ar = call double @llvm.fabs.f64(double %r)
  %as = call double @llvm.fabs.f64(double %s)
  %size2 = fadd reassoc contract double %acx, %acy
  %size3 = fadd reassoc contract double %size2, %adx
  %size4 = fadd reassoc contract double %size3, %ady
  %size5 = fadd reassoc contract double %size4, %ar
  %size = fadd reassoc contract double %size5, %as
  %radii = fadd double %r, %s
  %wide = call double @llvm.fabs.f64(double %radii)
  %share = fmul double %wide, 0x3CB0000000000000
  %doubt = fmul double %size, %share
  %sized = call double @llvm.fabs.f64(double %left)
  %sure = fcmp ogt double %sized, %doubt
  %none = fmul double %left, 0.0
  %gap = select i1 %sure, double %left, double %none
  ret double %gap
}

define i64 @run(ptr noalias %rows, ptr noalias %out, ptr noalias %codes, ptr noalias %fixed, i64 %n, i64 %stride) #0 {
entry:
$fixed
  br label %loop
loop:
  %i = phi i64 [ 0, %entry ], [ %next, %loop ]
  %sofar = phi i64 [ 0, %entry ], [ %failed, %loop ]
$operations
  %failed = or i64 %sofar, $code
  %next = add nuw nsw i64 %i, 1
  %more = icmp slt i64 %next, %n
  br i1 %more, label %loop, label %done, !llvm.loop !0
done:
  fence seq_cst ; stores past the caches are over before another thread reads
  ret i64 %failed
}
!0 = distinct !{!0, !1, !3, !4}
!1 = !{!"llvm.loop.vectorize.enable", i1 true}
!2 = distinct !{}
!3 = !{!"llvm.loop.parallel_accesses", !2}
!4 = !{!"llvm.loop.interleave.count", i32 $vectors}
attributes #0 = { "prefer-vector-width"="512" } ; the full vector width of the machine
