using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Keeps the fat boxes around the pieces. A body that has moved less than its boxes allow costs a comparison; work is
/// proportional to what left its box.
/// </summary>
internal sealed unsafe class BoxStage : IStageWork
{
    /// <summary>A fat box is larger than the tight one by this share of the piece's extent, and by twice the step's motion.</summary>
    private const float MarginShare = 0.2f;
    private const float MotionShare = 2f;

    /// <summary>A margin this many times what a new box would get is given up.</summary>
    private const float Looseness = 2f;

    /// <summary>Contacts are kept up to this share of the extent apart; boxes must overlap before that.</summary>
    private const float SkinShare = 0.02f;

    /// <summary>A body that is foreseen to move by more than this share of its extent in a step is fast.</summary>
    private const float FastShare = 1f;

    /// <summary>2¹⁰⁰: at the edge of the floats' range a box must not become infinite, which the sorting of boxes cannot bear.</summary>
    private const float Farthest = 1.2676506e30f;

    /// <summary>Words of 64 bodies that are worth another worker's while, some 1 µs.</summary>
    private const int LeastWords = 4;

    private readonly Column<FitRecord> _fits = new Column<FitRecord>();

    /// <summary>Bodies that left their boxes or whose boxes are out of date for another reason, a bit each.</summary>
    private readonly Column<ulong> _left = new Column<ulong>();
    private World _world = null!;
    private float _dt;
    private float _pull;

    /// <summary>Looks at all bodies, and fits the boxes of those that left theirs.</summary>
    public void Update(World world, StageRunner runner, float dt)
    {
        BodyStore bodies = world.Bodies;
        int end = bodies.Ids.End;
        int words = (end + BitSet.WordBits - 1) / BitSet.WordBits;
        _fits.EnsureCapacity(end);
        _left.EnsureCapacity(words);
        _world = world;
        _dt = dt;
        _pull = (Math.Abs(world.Settings.Gravity.X) + Math.Abs(world.Settings.Gravity.Y)) * dt;
        runner.Run(this, words, LeastWords);
        for (int word = 0; word < words; word++)
        {
            ulong left = _left[word];
            for (int body = word * BitSet.WordBits; left != 0; body++, left >>= 1)
            {
                if ((left & 1) != 0)
                {
                    Take(world, body);
                }
            }
        }
    }

    /// <summary>Words of 64 bodies. A body that only moved gets its boxes here; one whose pieces or flags may have changed must wait.</summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        BodyStore bodies = _world.Bodies;
        ulong* visited = bodies.Visited.Words;
        for (int word = from; word < to; word++)
        {
            ulong left = 0;
            int first = Math.Max(1, word * BitSet.WordBits);
            int end = visited[word] == 0 ? first : Math.Min((word + 1) * BitSet.WordBits, bodies.Ids.End);
            for (int body = first; body < end; body++)
            {
                BodyFlags flags = bodies.Flags[body];
                if ((flags & BodyFlags.Moved) != 0)
                {
                    left |= 1UL << body;
                }
                else if (Moves(flags))
                {
                    float motion = Motion(bodies.State[body], _fits[body].Reach);
                    if (HasLeft(bodies, body, motion) || IsLoose(bodies, body, motion))
                    {
                        Refit(body);
                        left |= 1UL << body;
                    }

                    NoteSpeed(bodies, body, motion);
                }
            }

            _left[word] = left;
        }
    }

    private static bool Moves(BodyFlags flags)
    {
        const BodyFlags Moving = BodyFlags.Alive | BodyFlags.Enabled;
        return (flags & (Moving | BodyFlags.Static | BodyFlags.Asleep)) == Moving;
    }

    private void Take(World world, int body)
    {
        BodyStore bodies = world.Bodies;
        BodyFlags flags = bodies.Flags[body];
        if ((flags & BodyFlags.Moved) == 0)
        {
            for (int collider = world.FirstCollider(body); collider >= 0; collider = world.NextCollider(collider))
            {
                for (int piece = world.Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = world.Shapes.NextPiece[piece])
                {
                    world.NoteMoved(piece);
                }
            }

            return;
        }

        bodies.Flags[body] = flags & ~(BodyFlags.Moved | BodyFlags.Fast);
        Fit(world, body);
        if (Moves(flags))
        {
            NoteSpeed(bodies, body, Motion(bodies.State[body], bodies.Size[body].Reach));
        }
    }

    private static void NoteSpeed(BodyStore bodies, int body, float motion)
    {
        BodyFlags flags = bodies.Flags[body];
        BodyFlags now = motion > bodies.Size[body].Extent ? flags | BodyFlags.Fast : flags & ~BodyFlags.Fast;
        if (now != flags)
        {
            bodies.Flags[body] = now;
        }
    }

    private bool HasLeft(BodyStore bodies, int body, float motion)
    {
        ref FitRecord fit = ref _fits[body];
        ref BodyPose pose = ref bodies.Pose[body];
        float travel = (float)(Math.Abs(pose.X - fit.X) + Math.Abs(pose.Y - fit.Y) + (Math.Abs(pose.Angle - fit.Angle) * fit.Reach));
        return !(travel + motion <= fit.Margin);
    }

    /// <summary>
    /// A body that was fast when it got its boxes and rests now would never leave them, and be paired with all around it for as long:
    /// pentagons that had fallen ten metres lay with twenty pairs each, of which two had points.
    /// </summary>
    private bool IsLoose(BodyStore bodies, int body, float motion) =>
        _fits[body].Margin > Looseness * (((MarginShare - SkinShare) * bodies.Size[body].Extent) + (MotionShare * motion));

    private float Motion(in BodyState state, float reach) =>
        (Math.Abs(state.LinearVelocity.X) + Math.Abs(state.LinearVelocity.Y) + _pull + (Math.Abs(state.AngularVelocity) * reach)) * _dt;

    private void Fit(World world, int body)
    {
        ref BodyPose pose = ref world.Bodies.Pose[body];
        bool alive = (world.Bodies.Flags[body] & (BodyFlags.Alive | BodyFlags.Enabled)) == (BodyFlags.Alive | BodyFlags.Enabled);
        bool isStatic = (world.Bodies.Flags[body] & BodyFlags.Static) != 0;
        float extent = float.MaxValue;
        FitRecord fit = Begin(pose);
        for (int collider = world.FirstCollider(body); collider >= 0; collider = world.NextCollider(collider))
        {
            for (int piece = world.Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = world.Shapes.NextPiece[piece])
            {
                world.SetProxy(piece, FatBox(world, body, piece, isStatic, ref fit), alive, isStatic);
                extent = Math.Min(extent, world.Shapes.Pieces[piece].Extent);
            }
        }

        world.Bodies.Size[body] = new BodySize { Extent = FastShare * extent, Reach = fit.Reach };
        world.NoteSize(body, fit.Reach > 0 ? extent : 0, fit.Reach);
        _fits[body] = fit;
    }

    /// <summary>New boxes for a body that is what it was and has only moved.</summary>
    private void Refit(int body)
    {
        World world = _world;
        FitRecord fit = Begin(world.Bodies.Pose[body]);
        for (int collider = world.FirstCollider(body); collider >= 0; collider = world.NextCollider(collider))
        {
            for (int piece = world.Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = world.Shapes.NextPiece[piece])
            {
                ref ProxyInfo info = ref world.Proxies.Info[piece];
                if ((info.Flags & ProxyFlags.Alive) == 0)
                {
                    world.Bodies.Flags[body] |= BodyFlags.Moved;
                    return;
                }

                world.Proxies.Fat[piece] = FatBox(world, body, piece, isStatic: false, ref fit);
                info.Flags = ProxyFlags.Alive | ProxyFlags.Moved;
            }
        }

        _fits[body] = fit;
    }

    private static FitRecord Begin(in BodyPose pose) =>
        new FitRecord { X = pose.X, Y = pose.Y, Angle = pose.Angle, Margin = float.MaxValue };

    private Box FatBox(World world, int body, int piece, bool isStatic, ref FitRecord fit)
    {
        float reach = world.Shapes.Pieces[piece].Reach;
        float motion = isStatic ? 0 : Motion(world.Bodies.State[body], reach);
        float size = world.Shapes.Pieces[piece].Extent;
        float spare = isStatic ? SkinShare * size : (MarginShare * size) + (MotionShare * motion);
        Box fat = world.Shapes.TightBox(piece, world.Bodies.Pose[body]);
        spare = Math.Min(spare, Farthest);
        Expand(ref fat, spare);
        fit.Margin = Math.Min(fit.Margin, spare - (SkinShare * size));
        fit.Reach = Math.Max(fit.Reach, reach);
        return fat;
    }

    private static void Expand(ref Box box, float spare)
    {
        box = Box.FromDouble((double)box.MinX - spare, (double)box.MinY - spare, (double)box.MaxX + spare, (double)box.MaxY + spare);
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct FitRecord
    {
        public double X;
        public double Y;
        public double Angle;
        public float Reach;
        public float Margin;
    }
}
