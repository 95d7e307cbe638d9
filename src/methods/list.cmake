# The methods, in the order of menus and tables. Each is the file <id>.hpp of this folder with a class of that name
# (rk4 -> Rk4, verlet-2008 -> Verlet2008).
set(STEPLAB_METHODS
    euler
    midpoint
    rk4
    stoermer
    verlet
    velocity-verlet
    forest-ruth
    pefrl
    mclachlan-atela-5
    srkn-11b
    kahan-li-8
    euler-forward
    dopri5
    dop853
    rkn-12-10
    implicit-midpoint
    tr-bdf2
    taylor
    gauss-16
    ias15
    verlet-2008
    stoermer-2008)
