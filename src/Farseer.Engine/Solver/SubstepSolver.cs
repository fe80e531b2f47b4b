using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Springs;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>What the solver works on in one step.</summary>
internal unsafe ref struct SolverInput
{
    public StageRunner Runner;
    public BodyStore Bodies;

    /// <summary>Rows by colour, in the order of solving, and how many there are.</summary>
    public ReadOnlySpan<GraphColor> Colors;
    public int RowCount;

    /// <summary>Bundles of rows that there is memory for.</summary>
    public int BundleRoom;

    /// <summary>Where the second half of the bodies begins: see <see cref="RowGroups.Middle"/>.</summary>
    public int MiddleBody;

    /// <summary>The islands of the rows.</summary>
    public IslandStore Islands;

    /// <summary>Bodies with constraints, padded to whole bundles with body 0.</summary>
    public int* List;
    public int PaddedCount;

    /// <summary>Room for the velocities of the list, of all its places.</summary>
    public Vector4* Saved;

    /// <summary>What deep islands of many levels carry on of their pushes, by body; null: nothing.</summary>
    public CarriedPush* Pushes;
    public int Substeps;
    public float Substep;
    public ContactCoefficients Coefficients;
    public SpringStore? Springs;

    /// <summary>Share of a deep overlap that goes in one step.</summary>
    public float Recovery;
    public bool AnyDeep;
    public bool AnyBounce;

    /// <summary>Some island is small, and how many rows each body has.</summary>
    public bool AnySmall;
    public Vector2 GravityVector;
    public int* Degrees;

    /// <summary>Most contacts are new in this step and have no impulses to start from.</summary>
    public bool ColdStart;

    /// <summary>The joints, if there are any.</summary>
    public JointSolver? Joints;
    public IUserJoints? UserJoints;

    /// <summary>Keeps accounts of the substeps, if somebody wants them.</summary>
    public ISolverAudit? Audit;

    /// <summary>Sums what contacts give, if somebody reads it.</summary>
    public ContactImpulses? Impulses;

    /// <summary>Surfaces that run past their bodies or resist rolling, if there are any.</summary>
    public PairSurfaces? Surfaces;
}

/// <summary>
/// The substeps of a step: small steps with one pass of each kind beat many passes on a large one at the same cost. Each
/// substep: velocities, springs, warm start, biased pass, positions, relax pass, impacts.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class SubstepSolver
{
    /// <summary>
    /// Sweeps of each pass in a step in which most contacts are new: without impulses to start from a pile sinks and spreads
    /// before its lowest contacts feel the load. A pyramid of 20 ends 3 mm off instead of 11.
    /// </summary>
    private const int ColdStartSweeps = 4;

    /// <summary>
    /// Up to <see cref="FewRows"/> the sweeps of a cold start cost next to nothing, and there are more: a body that lands on
    /// several contacts at once stops without turning only when they have settled among themselves, a factor of 2 to 4 a sweep.
    /// </summary>
    private const int FewRows = 64;
    private const int FewRowsSweeps = 16;

    private readonly BodyPasses _bodies = new BodyPasses();
    private readonly ContactPasses _passes = new ContactPasses();
    private readonly UserJointPass _userJoints = new UserJointPass();
    private readonly ImpactPass _impacts = new ImpactPass();
    private readonly FreeImpacts _free = new FreeImpacts();
    private SurfacePass? _surfaces;

    /// <summary>Makes room ahead for so many bundles of rows.</summary>
    public void Reserve(int bundles) => _passes.ReserveBundles(bundles);

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _bodies.Forget();
        _passes.Forget();
        _impacts.Forget();
        _free.Small.Forget();
        _surfaces?.Forget();
    }

    public void Solve(in SolverInput input)
    {
        ContactCoefficients coefficients = input.Coefficients;
        _bodies.Begin(input);
        double recovery = input.AnyDeep ? RecoveryRate(input.Recovery, input.Substeps) * (double)coefficients.ErrorScale : 0;
        ReadOnlySpan<GraphColor> colors = input.Colors;
        if (input.Joints != null)
        {
            colors = TakeTreeContacts(colors, input.Joints) ? colors : default;
            input.Joints.Start(coefficients);
            _bodies.Use(input.Joints.Chains.Movers(input.List, input.PaddedCount, out int movers), movers);
        }

        bool impacts = FindImpacts(input);
        SurfacePass? surfaces = BeginSurfaces(input);

        _passes.Begin(input.Runner, input.Bodies, coefficients, input.Colors, input.BundleRoom, input.MiddleBody > 0);

        int sweeps = !input.ColdStart ? 1 : input.RowCount <= FewRows ? FewRowsSweeps : ColdStartSweeps;

        // Trees that no contact on lanes concerns make all their sweeps in one walk.
        int jointSweeps = sweeps > 1 && input.Joints != null && IsApart(colors, input.Joints) ? 1 : sweeps;
        for (int substep = 0; substep < input.Substeps; substep++)
        {
            WatchApproaches(input);
            if (impacts)
            {
                PrepareImpacts(input);
            }

            input.Runner.Call();
            input.Audit?.BeginSubstep();
            _bodies.IntegrateVelocities();
            input.Audit?.Book(SolverPart.Drive);
            input.Springs?.Apply(input.Bodies, input.Substep);
            input.Audit?.Book(SolverPart.Springs);
            input.Joints?.Enter();
            input.Audit?.Book(SolverPart.Joints);
            _passes.WarmStart(colors);
            surfaces?.WarmStart();
            input.Audit?.Book(SolverPart.Contacts);
            for (int sweep = 0; sweep < sweeps; sweep++)
            {
                input.Joints?.Wishes.SolveWishes(biased: true);
                input.Audit?.Book(SolverPart.Joints);
                _passes.SolveBiased(colors, input.AnyDeep);
                input.Audit?.Book(SolverPart.Contacts);
                if (sweep < jointSweeps)
                {
                    input.Joints?.Solve(sweep > 0, sweeps / jointSweeps);
                }

                input.Audit?.Book(SolverPart.Joints);
            }

            if (input.UserJoints != null)
            {
                _userJoints.Run(input.UserJoints, input.Bodies, input.List, input.PaddedCount, input.Substeps, coefficients.InverseSubstep);
                input.Audit?.Book(SolverPart.UserJoints);
            }

            if (input.AnyDeep && input.Recovery > 0)
            {
                PushOutAndMove(colors, (float)recovery * coefficients.InverseSubstep);
            }
            else
            {
                _bodies.IntegratePositions();
            }

            if (input.Joints != null)
            {
                CorrectJoints(input, input.Joints, recovery);
            }

            input.Audit?.Book(SolverPart.Joints);

            // Friction waits for the second half: it would answer turns that the normals make only until they have settled.
            for (int sweep = 0; sweep < sweeps; sweep++)
            {
                bool rub = sweep * 2 >= sweeps - 1;
                input.Joints?.Wishes.SolveWishes(biased: false);
                input.Audit?.Book(SolverPart.Joints);
                _passes.Relax(colors, rub, sweep == 0);
                input.Audit?.Book(SolverPart.Contacts);
                if (sweep < jointSweeps)
                {
                    input.Joints?.Relax(sweep > 0, rub || jointSweeps == 1, sweeps / jointSweeps);
                }

                input.Audit?.Book(SolverPart.Joints);
            }

            if (impacts)
            {
                _impacts.Run(input, _passes);
            }

            surfaces?.Solve();
            input.Joints?.Contacts.NoteLoads();
            if (impacts)
            {
                _impacts.Finish(input, _passes);
                input.Joints?.Impacts.Bounce();
                input.Audit?.Book(SolverPart.Impacts);
                input.Joints?.Impacts.Settle();
                input.Audit?.Book(SolverPart.Joints);
            }

            SumImpulses(input);
            input.Audit?.EndSubstep();
        }

        input.Joints?.Finish();
    }

    private static void SumImpulses(in SolverInput input)
    {
        if (input.Impulses != null)
        {
            AddImpulses(input.Colors, input.Impulses, 1);
            input.Joints?.Impacts.AddImpulses(input.Impulses, 1);
        }
    }

    private SurfacePass? BeginSurfaces(in SolverInput input)
    {
        if (input.Surfaces == null)
        {
            return null;
        }

        _surfaces ??= new SurfacePass();
        _surfaces.Begin(input);
        return _surfaces;
    }

    /// <summary>Adds what all rows hold to the sums of the step.</summary>
    /// <param name="colors">The rows.</param>
    /// <param name="impulses">The sums.</param>
    /// <param name="sign">1, or -1 to take it off again.</param>
    internal static void AddImpulses(ReadOnlySpan<GraphColor> colors, ContactImpulses impulses, double sign)
    {
        for (int i = 0; i < colors.Length; i++)
        {
            foreach (ContactBundle* row in colors[i].Bundles)
            {
                impulses.Add(row, sign);
            }
        }
    }

    /// <summary>Before impacts are held back, which hides their points.</summary>
    private static void WatchApproaches(in SolverInput input)
    {
        if (input.Impulses is not { } impulses)
        {
            return;
        }

        for (int i = 0; i < input.Colors.Length; i++)
        {
            foreach (ContactBundle* row in input.Colors[i].Bundles)
            {
                impulses.Watch(row, input.Bodies.State.Pointer);
            }
        }

        input.Joints?.Impacts.WatchApproaches(impulses);
    }

    /// <summary>Positions by the joints; bodies that only they moved may be for all to move from here on.</summary>
    private void CorrectJoints(in SolverInput input, JointSolver joints, double recovery)
    {
        joints.Positions.CorrectPositions(recovery);
        if (joints.NetsDisturbed)
        {
            PullNets(joints);
        }

        joints.Positions.EndPositions();
        if (joints.Chains.GivesBodiesBack)
        {
            _bodies.Use(input.List, input.PaddedCount);
        }
    }

    /// <returns>True if the colours have contacts left.</returns>
    private static bool TakeTreeContacts(ReadOnlySpan<GraphColor> colors, JointSolver joints)
    {
        bool left = false;
        for (int i = 0; i < colors.Length; i++)
        {
            BundleRuns runs = colors[i].Runs;
            while (runs.Next())
            {
                left |= joints.Contacts.Take(runs.Bundles, runs.Count);
            }
        }

        return left;
    }

    private static bool IsApart(ReadOnlySpan<GraphColor> colors, JointSolver joints)
    {
        bool apart = joints.Contacts.SweepsByItself();
        for (int i = 0; apart && i < colors.Length; i++)
        {
            BundleRuns runs = colors[i].Runs;
            while (apart && runs.Next())
            {
                apart = !joints.Contacts.SharesBodies(runs.Bundles, runs.Count);
            }
        }

        return apart;
    }

    /// <returns>False: no contact can have an impact by itself in this step.</returns>
    private bool FindImpacts(in SolverInput input)
    {
        if (!input.AnySmall && !input.AnyBounce)
        {
            return false;
        }

        // Once such an island is there, later steps are not to allocate, whatever is struck in them.
        bool jointed = input.Joints != null && input.AnyBounce;
        _free.Reserve(input.Bodies.State.Capacity, input.BundleRoom);
        _impacts.Reserve(input.Bodies.State.Capacity, input.BundleRoom, input.AnyBounce);

        bool free = input.AnySmall && input.UserJoints == null;
        if (free)
        {
            _free.Find(input.Colors, input.Degrees, input.Joints, input.Springs, input.Islands);
        }

        bool any = _impacts.Begin(input.Colors, input.Bodies, input.AnyBounce, free ? _free : null, input.Coefficients.Driven);
        if (any)
        {
            _passes.ReserveChosen(input.Bodies.Ids.End);
        }

        return any || jointed;
    }

    private void PrepareImpacts(in SolverInput input)
    {
        _impacts.Prepare(input.Bodies, input.Coefficients);
        input.Joints?.Impacts.PrepareBounce();
    }

    /// <summary>Moves everything with the velocities that push deep islands apart, and then takes these velocities away again.</summary>
    private void PushOutAndMove(ReadOnlySpan<GraphColor> colors, float rate)
    {
        _bodies.AddPushes();
        _passes.PushOut(colors, rate);
        _bodies.IntegratePositions();
        _bodies.RememberPushes();
    }

    /// <summary>Displaces the bodies of nets; the velocities that do it are forgotten.</summary>
    private void PullNets(JointSolver joints)
    {
        _bodies.SaveVelocities();
        _bodies.Stop();
        joints.PullNets();
        _bodies.IntegratePositions();
        _bodies.RestoreVelocities();
        joints.NetsPulled();
    }

    /// <summary>Share r a substep with which n substeps remove the share of a step: 1 - (1 - r)^n = share, by bisection.</summary>
    private static float RecoveryRate(float share, int substeps)
    {
        double low = 0;
        double high = 1;
        for (int i = 0; i < 40; i++)
        {
            double middle = (low + high) / 2;
            double left = 1;
            for (int k = 0; k < substeps; k++)
            {
                left *= 1 - middle;
            }

            if (1 - left < share)
            {
                low = middle;
            }
            else
            {
                high = middle;
            }
        }

        return (float)low;
    }
}
