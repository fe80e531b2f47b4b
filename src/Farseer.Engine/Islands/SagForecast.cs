using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Settings;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// Foresees how far each island sinks under its own weight: what lies above a level, shared among the contacts of that level, on
/// their softness. It takes masses, contacts and the length of the step, not the present motion, so a stack has its substeps from its
/// first step on, as long as it rests. The substeps that a user asks for do not enter either: they divide the error by four for each
/// doubling, whatever an island adds to them.
/// </summary>
internal sealed unsafe class SagForecast
{
    /// <summary>
    /// Sag, in sizes of the bodies and summed over the levels, from which on an island takes twice the substeps; and how many times as
    /// much sag doubles them again. A stack of 8 boxes of 1 m is the first at 60 steps a second, a pyramid of 18 rows, a box on one of a
    /// thirtieth of its mass.
    /// </summary>
    private const double LargestShare = 3.5e-4;
    private const double Growth = 14;

    /// <summary>
    /// From so many levels on an island that is wider than a stack takes twice the substeps once more: its levels also spread, and come
    /// to rest the later the more there are.
    /// </summary>
    private const int ManyLevels = 16;
    private const double WideShare = 1.5;

    /// <summary>
    /// An island of so many levels that all but rests for so many times to sleep, the longer watch of <see cref="RestJudge"/>, and does not
    /// fall asleep takes twice the substeps, and after as long again four times as many: with the usual ones the loads of a heap go to and
    /// fro at the limit of friction, and it creeps. Asleep it costs nothing.
    /// </summary>
    private const int ManyLevelsToSleep = 4;
    private const float TimesToSleep = 8;
    private const float MostForSleep = 2;

    /// <summary>
    /// A surface that leans carries its load by pressing harder, as in an arch; not beyond this (cosine), where others carry it.
    /// </summary>
    private const double LeastSteepness = 0.25;

    /// <summary>
    /// A larger island would pay with more time than its sag is worth: it is the scene. A contact between two bodies has two ends.
    /// </summary>
    private const int MostEnds = 4096;

    /// <summary>
    /// Levels squared times the ratio of masses from which on an island is worth a look. The sag of a stack of equal boxes grows with
    /// the square of its levels, whatever their size.
    /// </summary>
    private const double LeastLoad = 16;

    /// <summary>
    /// Sag is all that is seen of an island at rest, and not seen at all in one that moves. An island rests if nothing in it is faster
    /// than what falls for so many steps from rest, and goes on resting up to the second number.
    /// </summary>
    private const float RestSteps = 1;
    private const float UnrestSteps = 4;

    /// <summary>
    /// Steps that an island goes without after it was pushed apart: fine substeps would make speed of what is left of an overlap.
    /// </summary>
    private const byte StepsAfterDeep = 60;

    private readonly Column<byte> _wait = new Column<byte>();
    private readonly Column<Island> _islands = new Column<Island>();
    private readonly Column<byte> _fine = new Column<byte>();
    private readonly Column<byte> _doublings = new Column<byte>();

    /// <summary>By body: seconds since its island has all but rested.</summary>
    private readonly Column<float> _calm = new Column<float>();
    private readonly StartingLoads _loads = new StartingLoads();

    // By slot of the islands, in scratch memory, while they are judged.
    private Level* _levels;
    private int _islandCount;
    private bool _any;
    private Vector2 _gravity;
    private float _dt;
    private float _timeToSleep;

    /// <summary>How often the substeps of an island are to be doubled.</summary>
    public int DoublingsOf(int island) => _doublings[island];

    /// <summary>Some island takes more substeps from this step on.</summary>
    public bool AnyRaised { get; private set; }

    /// <summary>An island that does.</summary>
    public bool IsRaised(int island) => island < _islandCount && _islands[island].Raised;

    /// <summary>Looks which islands may need more, if they or the step have changed.</summary>
    /// <param name="islands">The islands.</param>
    /// <param name="graph">Their rows.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="dt">The step, seconds.</param>
    /// <param name="gravity">Gravity of the world.</param>
    /// <param name="timeToSleep">Seconds for which what rests must do so to fall asleep; infinite if nothing may.</param>
    /// <param name="rebuilt">The islands were built anew.</param>
    public void Begin(
        IslandStore islands, ConstraintGraph graph, BodyStore bodies, float dt, Vector2 gravity, float timeToSleep, bool rebuilt)
    {
        ReserveIslands(islands.Count);
        _fine.EnsureCapacity(bodies.Ids.End);
        _wait.EnsureCapacity(bodies.Ids.End);
        _calm.EnsureCapacity(bodies.Ids.End);
        if (!rebuilt && dt == _dt && gravity == _gravity && timeToSleep == _timeToSleep)
        {
            return;
        }

        _timeToSleep = timeToSleep;
        _dt = dt;
        _gravity = gravity;
        _any = false;
        _islandCount = islands.Count;
        for (int i = 0; i < islands.Count; i++)
        {
            _doublings[i] = 0;
            _islands[i] = default;
        }

        if (gravity == Vector2.Zero)
        {
            return;
        }

        CountBodies(islands, graph.Degrees, bodies.Mass.Pointer);
        for (int i = 0; i < islands.Count; i++)
        {
            ref Island island = ref _islands[i];
            double levels = islands.FirstSlot[i + 1] - islands.FirstSlot[i];
            island.Open = island.Ends <= MostEnds && levels * levels * island.Heaviest >= LeastLoad * island.Lightest;
            _any |= island.Open;
        }
    }

    /// <summary>
    /// Bodies, contacts and masses of each island. Neighbours in number are mostly of one island, whose sums stay at hand as long as that
    /// is so: to read and write them for each body, one waiting for the one before, was a hundredth of a step.
    /// </summary>
    private void CountBodies(IslandStore islands, int* degrees, BodyMass* masses)
    {
        int current = -1;
        int count = 0;
        int ends = 0;
        float lightest = 0;
        float heaviest = 0;
        for (int body = 0; body < islands.BodyEnd; body++)
        {
            int island = islands.Of(body);
            if (island < 0)
            {
                continue;
            }

            if (island != current)
            {
                Keep(current, count, ends, lightest, heaviest);
                current = island;
                ref Island entry = ref _islands[island];
                count = entry.Bodies;
                ends = entry.Ends;
                lightest = entry.Lightest;
                heaviest = entry.Heaviest;
            }

            float mass = masses[body].Mass;
            lightest = count == 0 ? mass : Math.Min(lightest, mass);
            heaviest = Math.Max(heaviest, mass);
            ends += degrees[body];
            count++;
        }

        Keep(current, count, ends, lightest, heaviest);
    }

    private void Keep(int island, int bodies, int ends, float lightest, float heaviest)
    {
        if (island >= 0)
        {
            ref Island entry = ref _islands[island];
            entry.Bodies = bodies;
            entry.Ends = ends;
            entry.Lightest = lightest;
            entry.Heaviest = heaviest;
        }
    }

    /// <summary>How often the substeps of each island are to be doubled in this step.</summary>
    /// <returns>True if any takes more than the step.</returns>
    public bool Find(
        IslandStore islands, FeedForwardSettings feedForward, ConstraintGraph graph, BodyStore bodies, int* list, int count,
        in ContactCoefficients c, Scratch scratch)
    {
        AnyRaised = false;
        if (!_any)
        {
            return false;
        }

        CollectMotion(islands, feedForward, bodies, list, count);
        float slow = c.Gravity * _dt;
        bool unknown = false;
        for (int i = 0; i < _islandCount; i++)
        {
            ref Island island = ref _islands[i];
            bool rests = island.Fastest <= slow * (island.WasFine || island.MayCreep ? UnrestSteps : RestSteps);
            island.Calm = rests ? island.Calm + _dt : 0;
            island.Wanted = island.Open && island.Wait == 0 && rests;
            unknown |= island.Wanted && !island.Known;
        }

        if (unknown)
        {
            var usual = new ContactCoefficients(_dt / WorldSettings.DefaultSubsteps, c.Gravity, c.BounceThreshold);
            _levels = scratch.Take<Level>(islands.SlotCount);
            Collect(islands, graph, bodies, usual);
            Decide(islands, usual);
            GiveLoads(islands, graph, bodies, c, scratch);
        }

        bool any = false;
        _any = false;
        for (int i = 0; i < _islandCount; i++)
        {
            _any |= _islands[i].Open;
            _doublings[i] = _islands[i].Wanted ? DoublingsOf(_islands[i]) : (byte)0;
            any |= _doublings[i] > 0;
            _islands[i].Raised = _doublings[i] > 0 && !_islands[i].WasFine;
            AnyRaised |= _islands[i].Raised;
        }

        for (int i = 0; i < count; i++)
        {
            int island = IslandOf(islands, list[i]);
            _calm[list[i]] = island >= 0 && _islands[island].Open ? _islands[island].Calm : 0;
            _fine[list[i]] = island >= 0 ? _doublings[island] : (byte)0;
            _wait[list[i]] = (byte)(island >= 0 && _islands[island].Wait > 0 ? _islands[island].Wait - 1 : 0);
        }

        return any;
    }

    /// <summary>
    /// There are at most as many islands, and levels in all, as bodies: later steps allocate nothing, whatever piles up in them. A world
    /// that was built dense has fewer.
    /// </summary>
    public void Reserve(int bodyEnd)
    {
        ReserveIslands(bodyEnd);
        _fine.EnsureCapacity(bodyEnd);
        _wait.EnsureCapacity(bodyEnd);
        _calm.EnsureCapacity(bodyEnd);
    }

    private void ReserveIslands(int islands)
    {
        _islands.EnsureCapacity(islands);
        _doublings.EnsureCapacity(islands);
    }

    private byte DoublingsOf(in Island island) =>
        island.MayCreep ? (byte)Math.Min(island.Calm / (TimesToSleep * _timeToSleep), MostForSleep) : island.Doublings;

    private void CollectMotion(IslandStore islands, FeedForwardSettings feedForward, BodyStore bodies, int* list, int count)
    {
        for (int i = 0; i < _islandCount; i++)
        {
            _islands[i].Fastest = 0;
            _islands[i].WasFine = false;
            _islands[i].Calm = float.MaxValue;
            _islands[i].Wait = feedForward.IsDeep(i) ? StepsAfterDeep : (byte)0;
        }

        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            int at = IslandOf(islands, body);
            if (at >= 0 && _islands[at].Open)
            {
                ref Island island = ref _islands[at];
                ref BodyState state = ref bodies.State[body];
                float speed = Math.Abs(state.LinearVelocity.X) + Math.Abs(state.LinearVelocity.Y)
                    + (Math.Abs(state.AngularVelocity) * bodies.Size[body].Reach);
                island.Fastest = Math.Max(island.Fastest, speed);
                island.WasFine |= _fine[body] != 0;
                island.Calm = Math.Min(island.Calm, _calm[body]);
                island.Wait = Math.Max(island.Wait, _wait[body]);
            }
        }
    }

    /// <summary>-1 for a body that has come since the islands were built.</summary>
    private int IslandOf(IslandStore islands, int body)
    {
        int island = body < islands.BodyEnd ? islands.Of(body) : -1;
        return island < _islandCount ? island : -1;
    }

    private void Collect(IslandStore islands, ConstraintGraph graph, BodyStore bodies, in ContactCoefficients c)
    {
        for (int i = 0; i < islands.SlotCount; i++)
        {
            _levels[i] = default;
        }

        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    if (bundle->Contact[lane] >= 0 && _islands[islands.OfSlot[bundle->Slot[lane]]].Wanted)
                    {
                        AddRow(bundle, lane, bodies.Size.Pointer, c);
                    }
                }
            }
        }

        for (int body = 0; body < islands.BodyEnd; body++)
        {
            int island = islands.Of(body);
            int level = islands.LevelOf(body);
            if (island >= 0 && level >= 0 && _islands[island].Wanted && (bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0)
            {
                _levels[islands.FirstSlot[island] + level].Mass += bodies.Mass[body].Mass;
            }
        }
    }

    private void AddRow(ContactBundle* bundle, int lane, BodySize* sizes, in ContactCoefficients c)
    {
        ref Level level = ref _levels[bundle->Slot[lane]];
        float size = 2 * Math.Min(ExtentOf(sizes[bundle->BodyA[lane]]), ExtentOf(sizes[bundle->BodyB[lane]]));
        double load = (bundle->Flags[lane] & ContactBundle.SingleMark) != 0 ? 1 : 0.5;
        double steep = (1 / c.Gravity) * Math.Abs((bundle->NormalX[lane] * _gravity.X) + (bundle->NormalY[lane] * _gravity.Y));
        load /= Math.Max(steep, LeastSteepness);
        level.Softness += load * bundle->K11[lane] * c.FeedRestOf(size) / size;
        level.Rows++;
    }

    private static float ExtentOf(in BodySize size) => size.Extent > 0 ? size.Extent : float.MaxValue / 4;

    private void Decide(IslandStore islands, in ContactCoefficients c)
    {
        double sag = (double)c.Gravity * c.Substep * c.Sag(1);
        for (int i = 0; i < islands.Count; i++)
        {
            if (!_islands[i].Wanted || _islands[i].Known)
            {
                continue;
            }

            double above = 0;
            double share = 0;
            for (int slot = islands.FirstSlot[i + 1] - 1; slot >= islands.FirstSlot[i]; slot--)
            {
                ref Level level = ref _levels[slot];
                above += level.Mass;
                if (level.Rows > 0)
                {
                    share += above * sag * level.Softness / ((double)level.Rows * level.Rows);
                }
            }

            byte doublings = 0;
            for (double limit = LargestShare; share > limit && doublings < JointLoads.MostDoublings; limit *= Growth)
            {
                doublings++;
            }

            int levels = islands.FirstSlot[i + 1] - islands.FirstSlot[i];
            bool wide = _islands[i].Bodies > WideShare * levels;
            if (doublings > 0 && doublings < JointLoads.MostDoublings && levels >= ManyLevels && wide)
            {
                doublings++;
            }

            _islands[i].MayCreep = doublings == 0 && levels >= ManyLevelsToSleep && wide && !float.IsInfinity(_timeToSleep);

            _islands[i].Doublings = doublings;
            _islands[i].Known = true;
            _islands[i].Starts = doublings > 0;
            _islands[i].Open = doublings > 0 || _islands[i].MayCreep;
        }
    }

    /// <summary>Islands whose sag asks for more substeps have a long way to their load: those that were just judged are given it.</summary>
    private void GiveLoads(IslandStore islands, ConstraintGraph graph, BodyStore bodies, in ContactCoefficients c, Scratch scratch)
    {
        bool any = false;
        for (int i = 0; i < _islandCount; i++)
        {
            any |= _islands[i].Starts;
        }

        if (!any)
        {
            return;
        }

        _loads.Begin(_islandCount);
        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    int island = islands.OfSlot[bundle->Slot[lane]];
                    if (bundle->Contact[lane] >= 0 && _islands[island].Starts)
                    {
                        _loads.Add(island, bundle, lane);
                    }
                }
            }
        }

        for (int i = 0; i < _islandCount; i++)
        {
            if (_islands[i].Starts)
            {
                _loads.Give(i, bodies, _gravity, c);
                _islands[i].Starts = false;
            }
        }
    }

    private struct Level
    {
        public double Mass;
        public double Softness;
        public int Rows;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    private struct Island
    {
        public int Bodies;

        /// <summary>Contacts at each body, summed: those between two bodies count twice.</summary>
        public int Ends;
        public float Lightest;
        public float Heaviest;
        public float Fastest;

        /// <summary>Seconds since it has all but rested.</summary>
        public float Calm;

        /// <summary>It may need more: its sag is worth a look, or it may creep.</summary>
        public bool Open;

        /// <summary>It needs no more for its sag, but is a heap that may be kept awake by its own solution.</summary>
        public bool MayCreep;

        /// <summary>It may have more in this step.</summary>
        public bool Wanted;

        /// <summary>Its sag has been foreseen.</summary>
        public bool Known;

        /// <summary>It was foreseen in this step.</summary>
        public bool Starts;
        public byte Doublings;
        public bool WasFine;

        /// <summary>It has more in this step, and had not in the one before.</summary>
        public bool Raised;
        public byte Wait;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_wait);
        s.Column(_islands);
        s.Column(_fine);
        s.Column(_doublings);
        s.Column(_calm);
        s.Value(ref _islandCount);
        s.Value(ref _any);
        s.Value(ref _gravity);
        s.Value(ref _dt);
        s.Value(ref _timeToSleep);
        AnyRaised = s.Value(AnyRaised);
    }
}
