using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Simulation;

/// <summary>
/// Keeps the fat boxes around the pieces. A body that has moved less than its boxes allow costs a comparison; work is
/// proportional to what left its box.
/// </summary>
internal sealed unsafe class BoxStage : IStageWork
{
    /// <summary>
    /// A fat box is larger than the tight one by this share of the piece's extent all around, and reaches ahead by so many steps of
    /// the present motion. What is fast gets a new one in each step in any case.
    /// </summary>
    private const float MarginShare = 0.2f;

    /// <summary>
    /// What moves by more than this share of its extent in a step gets a new box soon in any case, for which it pays less in pairs with a
    /// smaller margin. What creeps would leave such a one again and again: with 0.1 for all a pyramid takes 1.08 of the time.
    /// </summary>
    private const float MovingShare = 0.06f;
    private const float MovingMarginShare = 0.05f;
    private const float StepsAhead = 2f;
    private const float FastStepsAhead = 1f;

    /// <summary>Margins this many times what a new box would get are given up.</summary>
    private const float Looseness = 2f;

    /// <summary>Contacts are kept up to this share of the extent apart; boxes must overlap before that.</summary>
    private const float SkinShare = 0.02f;

    /// <summary>A body that is foreseen to move by more than this share of its extent in a step is fast.</summary>
    private const float FastShare = 1f;

    /// <summary>2¹⁰⁰: at the edge of the floats' range a box must not become infinite, which the sorting of boxes cannot bear.</summary>
    private const float Farthest = 1.2676506e30f;

    /// <summary>Words of 64 bodies that are worth another worker's while, some 1 µs.</summary>
    private const int LeastWords = 4;

    private readonly WorldStores _stores;
    private readonly Column<FitRecord> _fits = new Column<FitRecord>();

    /// <summary>Bodies whose boxes are out of date for another reason than motion, a bit each.</summary>
    private readonly Column<ulong> _stale = new Column<ulong>();

    /// <summary>Pieces that each worker has given new boxes; the first one writes them to the list of the world.</summary>
    [NotState(Why.OfOneStep)]
    private IndexList[] _moved = { null! };
    [NotState(Why.Elsewhere)]
    private PairFinder _pairs = null!;
    [NotState(Why.OfOneStep)]
    private float _dt;
    [NotState(Why.OfOneStep)]
    private float _pull;

    public BoxStage(WorldStores stores) => _stores = stores;

    /// <summary>Looks at all bodies, and fits the boxes of those that left theirs.</summary>
    public void Update(PairFinder pairs, StageRunner runner, float dt)
    {
        BodyStore bodies = _stores.Bodies;
        int end = bodies.Ids.End;
        int words = (end + BitSet.WordBits - 1) / BitSet.WordBits;
        _fits.EnsureCapacity(end);
        _stale.EnsureCapacity(words);
        _pairs = pairs;
        _dt = dt;
        _pull = (Math.Abs(_stores.Settings.Gravity.X) + Math.Abs(_stores.Settings.Gravity.Y)) * dt;
        BeginMoved(runner.Workers);
        runner.Run(this, words, LeastWords);
        EndMoved();
        for (int word = 0; word < words; word++)
        {
            for (ulong stale = _stale[word]; stale != 0; stale &= stale - 1)
            {
                Take((word * BitSet.WordBits) + BitSet.LowestBit(stale));
            }
        }
    }

    /// <summary>
    /// Words of 64 bodies. A body that only moved gets its boxes here; one whose pieces or flags may have changed must wait.
    /// </summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        BodyStore bodies = _stores.Bodies;
        ulong* visited = bodies.Visited.Words;
        BodyFlags* allFlags = bodies.Flags.Pointer;
        BodyPose* poses = bodies.Pose.Pointer;
        BodyState* states = bodies.State.Pointer;
        BodySize* sizes = bodies.Size.Pointer;
        FitRecord* fits = _fits.Pointer;
        IndexList moved = _moved[worker];
        int* next = moved.Pointer + moved.Count;
        for (int word = from; word < to; word++)
        {
            ulong stale = 0;
            int first = Math.Max(1, word * BitSet.WordBits);
            int end = visited[word] == 0 ? first : Math.Min((word + 1) * BitSet.WordBits, bodies.Ids.End);
            for (int body = first; body < end; body++)
            {
                BodyFlags flags = allFlags[body];
                if ((flags & BodyFlags.Moved) != 0)
                {
                    stale |= 1UL << body;
                }
                else if (Moves(flags))
                {
                    // A new box does not change how far the piece reaches.
                    float motion = Motion(states[body], fits[body].Reach);
                    if (HasLeft(fits[body], poses[body], states[body]) || IsLoose(fits[body], states[body], sizes[body], motion))
                    {
                        int* behind = Refit(body, next);
                        stale |= behind == null ? 1UL << body : 0;
                        next = behind == null ? next : behind;
                    }

                    NoteSpeed(allFlags + body, sizes[body], motion);
                }
            }

            _stale[word] = stale;
        }

        moved.SetCount((int)(next - moved.Pointer));
    }

    /// <summary>Makes room for what workers list: they write without asking, and say at the end of a range how much.</summary>
    private void BeginMoved(int workers)
    {
        if (_moved.Length != workers)
        {
            _moved = new IndexList[workers];
            for (int i = 1; i < workers; i++)
            {
                _moved[i] = new IndexList();
            }
        }

        int pieces = _stores.Shapes.PieceIds.End;
        _moved[0] = _pairs.MovedProxies;
        _moved[0].Reserve(_moved[0].Count + pieces);
        for (int i = 1; i < workers; i++)
        {
            _moved[i].Reserve(pieces);
            _moved[i].Clear();
        }
    }

    /// <summary>
    /// What follows for a piece with a new box follows from no order among them, so neither does it matter who listed which.
    /// </summary>
    private void EndMoved()
    {
        IndexList all = _moved[0];
        for (int i = 1; i < _moved.Length; i++)
        {
            int* from = _moved[i].Pointer;
            int count = _moved[i].Count;
            int before = all.Count;
            all.SetCount(before + count);
            Buffer.MemoryCopy(from, all.Pointer + before, (long)count * sizeof(int), (long)count * sizeof(int));
        }
    }

    private static bool Moves(BodyFlags flags)
    {
        const BodyFlags Moving = BodyFlags.Alive | BodyFlags.Enabled;
        return (flags & (Moving | BodyFlags.Static | BodyFlags.Asleep)) == Moving;
    }

    private void Take(int body)
    {
        BodyStore bodies = _stores.Bodies;
        BodyFlags flags = bodies.Flags[body];
        bodies.Flags[body] = flags & ~(BodyFlags.Moved | BodyFlags.Fast);
        _pairs.NoteAltered(body);
        Fit(body);
        if (Moves(flags))
        {
            NoteSpeed(bodies.Flags.Pointer + body, bodies.Size[body], Motion(bodies.State[body], bodies.Size[body].Reach));
        }
    }

    private static void NoteSpeed(BodyFlags* flags, in BodySize size, float motion)
    {
        BodyFlags now = motion > size.Extent ? *flags | BodyFlags.Fast : *flags & ~BodyFlags.Fast;
        if (now != *flags)
        {
            *flags = now;
        }
    }

    /// <summary>Whether the fat boxes of a body hold it wherever it gets to from <paramref name="pose"/>.</summary>
    public bool Hold(in BodyPose pose, int body, in BodyReach reach)
    {
        ref FitRecord fit = ref _fits[body];
        double x = pose.X - fit.X;
        double y = pose.Y - fit.Y;
        double around = (Math.Abs(pose.Angle - fit.Angle) + reach.Turn) * fit.Reach;
        return around - (x + reach.MinX) <= fit.Left && around + x + reach.MaxX <= fit.Right
            && around - (y + reach.MinY) <= fit.Down && around + y + reach.MaxY <= fit.Up;
    }

    private bool HasLeft(in FitRecord fit, in BodyPose pose, in BodyState state)
    {
        float around = ((float)Math.Abs(pose.Angle - fit.Angle) * fit.Reach) + Swing(state, fit.Reach);
#if NET8_0_OR_GREATER
        // x and y of where the body is, and of where it gets to.
        Vector128<double> from = Vector128.LoadUnsafe(in pose.X) - Vector128.LoadUnsafe(in fit.X);
        Vector128<float> way = Vector128.Shuffle(state.LinearVelocity.AsVector128(), Vector128.Create(2, 3, 0, 1)) * _dt;
        Vector128<float> both = Vector128.Narrow(from, from) + way;
        Vector128<float> all = Vector128.Create(around);
        Vector128<float> room = Vector128.LoadUnsafe(in fit.Left);
        return !Vector128.LessThanOrEqualAll(all - both, Vector128.Shuffle(room, Vector128.Create(0, 1, 0, 1)))
            || !Vector128.LessThanOrEqualAll(all + both, Vector128.Shuffle(room, Vector128.Create(2, 3, 2, 3)));
#else
        float fromX = (float)(pose.X - fit.X);
        float fromY = (float)(pose.Y - fit.Y);
        float toX = fromX + (state.LinearVelocity.X * _dt);
        float toY = fromY + (state.LinearVelocity.Y * _dt);
        return !(around - Math.Min(fromX, toX) <= fit.Left && around + Math.Max(fromX, toX) <= fit.Right
            && around - Math.Min(fromY, toY) <= fit.Down && around + Math.Max(fromY, toY) <= fit.Up);
#endif
    }

    /// <summary>
    /// A body that was fast when it got its boxes and rests now would never leave them, and be paired with all around it for as long:
    /// pentagons that had fallen ten metres lay with twenty pairs each, of which two had points.
    /// </summary>
    private bool IsLoose(in FitRecord fit, in BodyState state, in BodySize size, float motion)
    {
        float around = ((MarginOf(motion, size.Extent) - SkinShare) * size.Extent) + (StepsAhead * Swing(state, fit.Reach));
        float ahead = StepsAhead * _dt * (Math.Abs(state.LinearVelocity.X) + Math.Abs(state.LinearVelocity.Y));
        return fit.Left + fit.Right + fit.Down + fit.Up > Looseness * ((4 * around) + ahead);
    }

    /// <summary>What turning and gravity may add to the motion of a step, in any direction.</summary>
    private float Swing(in BodyState state, float reach) => (_pull + (Math.Abs(state.AngularVelocity) * reach)) * _dt;

    private float Motion(in BodyState state, float reach) =>
        (Math.Abs(state.LinearVelocity.X) + Math.Abs(state.LinearVelocity.Y) + _pull + (Math.Abs(state.AngularVelocity) * reach)) * _dt;

    private void Fit(int body)
    {
        ref BodyPose pose = ref _stores.Bodies.Pose[body];
        bool alive = (_stores.Bodies.Flags[body] & (BodyFlags.Alive | BodyFlags.Enabled)) == (BodyFlags.Alive | BodyFlags.Enabled);
        bool isStatic = (_stores.Bodies.Flags[body] & BodyFlags.Static) != 0;
        float extent = float.MaxValue;
        FitRecord fit = Begin(pose);
        for (int collider = _stores.Colliders.First(body); collider >= 0; collider = _stores.Colliders.Next(collider))
        {
            for (int piece = _stores.Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _stores.Shapes.NextPiece[piece])
            {
                _pairs.SetProxy(piece, FatBox(body, piece, isStatic, ref fit), alive, isStatic);
                extent = Math.Min(extent, _stores.Shapes.Pieces[piece].Extent);
            }
        }

        _stores.Bodies.Size[body] = new BodySize { Extent = FastShare * extent, Reach = fit.Reach };
        _fits[body] = fit;
    }

    /// <summary>New boxes for a body that is what it was and has only moved.</summary>
    /// <returns>One past the last of its pieces in the list; null: it is not what it was.</returns>
    private int* Refit(int body, int* moved)
    {
        FitRecord fit = Begin(_stores.Bodies.Pose[body]);
        for (int collider = _stores.Colliders.First(body); collider >= 0; collider = _stores.Colliders.Next(collider))
        {
            for (int piece = _stores.Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _stores.Shapes.NextPiece[piece])
            {
                ref ProxyInfo info = ref _stores.Proxies.Info[piece];
                if ((info.Flags & ProxyFlags.Alive) == 0)
                {
                    _stores.Bodies.Flags[body] |= BodyFlags.Moved;
                    return null;
                }

                _stores.Proxies.Fat[piece] = FatBox(body, piece, isStatic: false, ref fit);
                info.Flags = ProxyFlags.Alive | ProxyFlags.Moved;
                *moved++ = piece;
            }
        }

        _fits[body] = fit;
        return moved;
    }

    private static FitRecord Begin(in BodyPose pose) => new FitRecord
    {
        X = pose.X,
        Y = pose.Y,
        Angle = pose.Angle,
        Left = float.MaxValue,
        Right = float.MaxValue,
        Down = float.MaxValue,
        Up = float.MaxValue,
    };

    private Box FatBox(int body, int piece, bool isStatic, ref FitRecord fit)
    {
        float reach = _stores.Shapes.Pieces[piece].Reach;
        float size = _stores.Shapes.Pieces[piece].Extent;
        float skin = SkinShare * size;
        Spare spare = isStatic ? new Spare(skin) : Ahead(_stores.Bodies.State[body], size, reach);
        fit.Left = Math.Min(fit.Left, spare.Left - skin);
        fit.Right = Math.Min(fit.Right, spare.Right - skin);
        fit.Down = Math.Min(fit.Down, spare.Down - skin);
        fit.Up = Math.Min(fit.Up, spare.Up - skin);
        fit.Reach = Math.Max(fit.Reach, reach);
        return _stores.Shapes.BoxAround(piece, _stores.Bodies.Pose[body], spare.ToBox());
    }

    private Spare Ahead(in BodyState state, float size, float reach)
    {
        float motion = Motion(state, reach);
        float steps = motion > FastShare * size ? FastStepsAhead : StepsAhead;
        float x = steps * _dt * state.LinearVelocity.X;
        float y = steps * _dt * state.LinearVelocity.Y;
        Spare spare = new Spare((MarginOf(motion, size) * size) + (steps * Swing(state, reach)));
        spare.Left += Math.Max(0, -x);
        spare.Right += Math.Max(0, x);
        spare.Down += Math.Max(0, -y);
        spare.Up += Math.Max(0, y);
        return spare;
    }

    private static float MarginOf(float motion, float size) => motion > MovingShare * size ? MovingMarginShare : MarginShare;

    /// <summary>By how much a fat box is larger than the tight one.</summary>
    private struct Spare
    {
        public float Left;
        public float Right;
        public float Down;
        public float Up;

        public Spare(float all) => Left = Right = Down = Up = all;

        public readonly Box ToBox() => new Box(
            Math.Min(Left, Farthest), Math.Min(Down, Farthest), Math.Min(Right, Farthest), Math.Min(Up, Farthest));
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct FitRecord
    {
        public double X;
        public double Y;
        public double Angle;
        public float Reach;

        /// <summary>How far the boxes may move each way until a piece may leave its fat box.</summary>
        public float Left;
        public float Down;
        public float Right;
        public float Up;

        /// <summary>0: what lies between fields is not always the same, and this is state.</summary>
        public float Spare;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_fits);
        s.Column(_stale);
    }
}

/// <summary>Where a body gets to: ranges of displacements from a pose, and the greatest turn, radians.</summary>
internal struct BodyReach
{
    public double MinX;
    public double MinY;
    public double MaxX;
    public double MaxY;
    public double Turn;
}
