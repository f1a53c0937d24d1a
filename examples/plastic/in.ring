# The bore of an ideally plastic ring is widened (Hill 1950). Prints its pressure against Hill's, the
# logarithm of the present radii. Set from outside by
#   lmp -in in.ring -var a 16
variable a        index 8         # radius of the bore, automata
variable ratio    index 3         # outer radius over it
variable widen    index 0.04      # by how much the bore is widened
variable slow     index 1         # how many times slower than 1000 steps for each automaton of its radius
variable yield    index 400       # stress in tension, MPa; E = 206000 MPa
variable laws     index d         # preset of pair_style mca
variable d        index 2.5       # diameter of an automaton, nm
variable name     index ring      # of the dump
variable frames   index 0         # 1: a dump of the last state

units           nano
dimension       2
boundary        m m p
atom_style      sphere
timestep        9e-5

variable        outer equal ${a}*${ratio}*${d}
variable        edge equal ${outer}*1.2
lattice         hex ${d} origin 0.1 0.07 0
region          box block -${edge} ${edge} -${edge} ${edge} -0.5 0.5 units box
create_box      1 box
region          disc sphere 0 0 0 ${outer} units box
region          hole sphere 0 0 0 $(v_a*v_d) units box
create_atoms    1 region disc
variable        cell equal ${d}^2*sqrt(3)/2
variable        B equal $(sqrt(atoms*v_cell/PI))
group           hole region hole
variable        A equal $(sqrt(count(hole)*v_cell/PI))
delete_atoms    group hole compress yes

pair_style      mca preset ${laws} viscosity none
pair_coeff      * * steel.mca strength ${yield} elastic_limit 1 yield_strength 1 yield_strain 0.3 &
                breaking_strain 0.49 diameter ${d}
neighbor        0.4 bin
neigh_modify    every 10 delay 0 check yes
mca_links       create all all

region          bore sphere 0 0 0 $((v_a+0.95)*v_d) units box
group           bore region bore
group           body subtract all bore
fix             integrate body nve/mca

# the bore moves radially, with its speed rising over the first tenth
variable        steps equal round(10*${a}*${slow})*100
variable        ramp equal 0.1*${steps}
variable        begun equal (step<v_ramp)
variable        way equal ${widen}/(0.95*${steps})*(v_begun*step^2/(2*v_ramp)+(1-v_begun)*(step-v_ramp/2))
variable        speed equal ${widen}/(0.95*${steps})/dt*(v_begun*step/v_ramp+1-v_begun)
fix             first all store/state 0 x y
variable        f atom ${A}^2/(f_first[1]^2+f_first[2]^2)
variable        ux atom v_way*v_f*f_first[1]
variable        uy atom v_way*v_f*f_first[2]
variable        vx atom v_speed*v_f*f_first[1]
variable        vy atom v_speed*v_f*f_first[2]
fix             move bore move variable v_ux v_uy NULL v_vx v_vy NULL
fix             damp body viscous $(0.2*2*mass(all)/count(all)*3200/(v_B-v_A))

# pressure by the work of the bore's forces in a motion that keeps the volume, u = a/r
variable        work atom -(fx*x+fy*y)/(x^2+y^2)
compute         p bore reduce sum v_work
variable        k equal ${yield}/sqrt(3)
variable        p equal c_p/(2*PI*${k})
variable        limit equal ln((${B}^2-${A}^2)/(${A}*(1+v_way))^2+1)
compute         state all mca/atom broken plastic sxx syy sxy mean
compute         broken all reduce sum c_state[1]
thermo          $(v_steps/20)
thermo_style    custom step v_way v_p v_limit c_broken pe ke
thermo_modify   format float %12.6g
if "${frames} > 0" then &
  "dump picture all custom ${steps} ${name}.dump id type x y vx vy c_state[*]" &
  "dump_modify picture sort id colname c_state[2] plastic"
run             ${steps}
print           "ring of $(v_A:%.4f) and $(v_B:%.4f) nm: p = $(v_p:%.3f) k, Hill $(v_limit:%.3f) k"
