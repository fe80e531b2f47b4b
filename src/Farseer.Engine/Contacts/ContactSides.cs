using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>
/// All that the update of a contact reads of one of its pieces, in one cache line of 64 bytes, in the order of
/// <see cref="SideLanes"/>: a piece has several contacts, so what lies in seven tables is put together once a step.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 64)]
internal struct ContactSide
{
    public float X;
    public float Y;
    public float Cos;
    public float Sin;

    public float HalfX;
    public float HalfY;
    public float Extent;
    public float Reach;

    public float VelocityX;
    public float VelocityY;
    public float AngularVelocity;
    public SideFlags Flags;

    public float InverseMass;
    public float InverseInertia;
    public float Friction;
    public float Restitution;
}

/// <summary>
/// The sides of all pieces, rewritten at the start of each narrow phase. They are forgotten at its end, but for worlds where some of them
/// may be left as they were, or compared with what they were.
/// </summary>
internal sealed unsafe class ContactSides
{
    /// <summary>The piece of an empty lane: its side is inert.</summary>
    public const int NoPiece = -1;

    private readonly Column<ContactSide> _sides = new Column<ContactSide>();
    private readonly Column<int> _hulls = new Column<int>();
    [NotState(Why.Elsewhere)]
    private BodySteps? _steps;
    private ContactSide* _first;
    private bool _isKept;

    /// <summary>A listener hears, or has heard, of a piece.</summary>
    public bool AnyHeard { get; private set; }

    /// <summary>The side of piece 0; that of <see cref="NoPiece"/> stands before it.</summary>
    public ContactSide* Pointer => _first + 1;

    /// <summary>
    /// Where the corners of each piece are, as <see cref="HullLanes.Pack"/> gives it: all that the kernels of hulls need besides. Something
    /// stands at <see cref="NoPiece"/>.
    /// </summary>
    public int* Hulls => _hulls.Pointer + 1;

    /// <summary>Makes room for the sides of all pieces.</summary>
    /// <param name="shapes">The pieces.</param>
    /// <param name="steps">Where a change of a side is noted; null if nobody asks.</param>
    /// <param name="maySleep">Bodies may fall asleep.</param>
    /// <param name="scratch">Where they are if they are not kept.</param>
    public void Begin(ShapeStore shapes, BodySteps? steps, bool maySleep, Scratch scratch)
    {
        _steps = steps;
        _isKept |= steps != null || maySleep;
        if (_isKept)
        {
            Keep(shapes);
        }
        else
        {
            _first = scratch.Take<ContactSide>(shapes.PieceIds.End + 1);
            _hulls.EnsureCapacity(shapes.PieceIds.End + 1);
        }

        _first[0] = new ContactSide { Cos = 1, HalfX = 1, HalfY = 1, Flags = SideFlags.Box };
    }

    /// <summary>Makes room ahead for sides that are kept from step to step.</summary>
    public void Reserve(ShapeStore shapes)
    {
        if (!_isKept)
        {
            _sides.EnsureCapacity(shapes.PieceIds.End + 1);
        }
    }

    /// <summary>Writes the sides of a piece that falls asleep: from now on they stay as they are.</summary>
    public void LayDown(ShapeStore shapes, BodyStore bodies, ProxyInfo* proxies, byte* moves, int piece)
    {
        _isKept = true;
        Keep(shapes);
        Prepare(shapes, bodies, proxies, moves, piece, piece + 1);
    }

    /// <summary>
    /// Writes the sides of pieces in a row, but for those asleep, which have not changed. The first begins a word of bits.
    /// </summary>
    public void Write(ShapeStore shapes, BodyStore bodies, ProxyInfo* proxies, byte* moves, int first, int end)
    {
        ulong* visited = shapes.VisitedPieces.Words;
        while (first < end)
        {
            int last = first;
            while (last < end && visited[last / BitSet.WordBits] != 0)
            {
                last = Math.Min((last | (BitSet.WordBits - 1)) + 1, end);
            }

            Prepare(shapes, bodies, proxies, moves, first, last);
            first = (last | (BitSet.WordBits - 1)) + 1;
        }
    }

    /// <summary>Writes the sides of pieces in a row.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public void Prepare(ShapeStore shapes, BodyStore bodies, ProxyInfo* proxies, byte* moves, int first, int end)
    {
        ContactSide* sides = Pointer;
        int* hulls = Hulls;
        Piece* pieces = shapes.Pieces.Pointer;
        ColliderInfo* colliders = shapes.Colliders.Pointer;
        BodyPose* poses = bodies.Pose.Pointer;
        BodyState* states = bodies.State.Pointer;
        BodyMass* masses = bodies.Mass.Pointer;
        BodyFlags* flags = bodies.Flags.Pointer;
        SideFlags heard = SideFlags.None;
        BodyStep* steps = _steps == null ? null : _steps.Pointer;
        for (int i = first; i < end; i++)
        {
            Piece* piece = pieces + i;
            if (piece->VertexCount == 0)
            {
                continue;
            }

            int body = piece->Body;
            ContactSide* side = sides + i;
            Place(side, piece, poses + body);
            side->Extent = piece->Extent;
            side->Reach = piece->Reach;
            BodyState* state = states + body;
            *(Vector2*)&side->VelocityX = state->LinearVelocity;
            side->AngularVelocity = state->AngularVelocity;
            ColliderInfo* collider = colliders + piece->Collider;

            // What sleeps can be moved: a contact with it wakes it before it is solved.
            uint bodyFlags = (uint)flags[body];
            uint moving = moves[body] | Bit(bodyFlags, (uint)BodyFlags.Asleep, 1);
            SideFlags before = side->Flags;
            SideFlags now = Describe(piece, (uint)proxies[i].Flags, (uint)collider->Flags, bodyFlags, moving);
            side->Flags = now;
            if (steps != null)
            {
                Note(steps + body, before, now);
            }

            heard |= now;
            hulls[i] = HullLanes.Pack(piece->VertexStart, piece->VertexCount);

            // Both at once, and both 0 for what cannot be moved.
            *(ulong*)&side->InverseMass = *(ulong*)&masses[body].InverseMass & (0 - (ulong)moving);
            *(Vector2*)&side->Friction = *(Vector2*)&collider->Friction;
        }

        // Workers only ever set it.
        if ((heard & SideFlags.Heard) != 0)
        {
            AnyHeard = true;
        }
    }

    // All that is written of a piece: in a world without pairs bodies fall asleep before any narrow phase has begun.
    private void Keep(ShapeStore shapes)
    {
        _sides.EnsureCapacity(shapes.PieceIds.End + 1);
        _hulls.EnsureCapacity(shapes.PieceIds.End + 1);
        _first = _sides.Pointer;
    }

    private static void Note(BodyStep* step, SideFlags before, SideFlags now)
    {
        // Several workers may write the same: each flag is a byte of its own, which is only ever set here.
        if ((now & SideFlags.NewBox) != 0)
        {
            step->HasNewBox = 1;
        }

        if (((before ^ now) & ~SideFlags.NewBox) != 0)
        {
            step->IsAltered = 1;
        }
    }

    /// <summary>Where a piece is from its body's centre, its axes and its half sides.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Place(ContactSide* side, Piece* piece, BodyPose* pose)
    {
        float cos = pose->Cos;
        float sin = pose->Sin;
        side->X = (cos * piece->Center.X) - (sin * piece->Center.Y);
        side->Y = (sin * piece->Center.X) + (cos * piece->Center.Y);
        side->Cos = (cos * piece->Axis.X) - (sin * piece->Axis.Y);
        side->Sin = (sin * piece->Axis.X) + (cos * piece->Axis.Y);
        *(Vector2*)&side->HalfX = piece->Half;
    }

    /// <summary>Without a branch: what one piece is says little of the next one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static SideFlags Describe(Piece* piece, uint proxy, uint collider, uint body, uint moving)
    {
        uint flags = (uint)SideFlags.Exists | (uint)piece->Traits;
        flags |= Bit(proxy, (uint)ProxyFlags.Moved, (uint)SideFlags.NewBox);
        flags |= Bit(moving, 1, (uint)SideFlags.Moves);
        flags |= Bit(moving & ~Bit(body, (uint)BodyFlags.IgnoreGravity, 1), 1, (uint)SideFlags.Pulled);
        flags |= Bit(collider, (uint)ColliderFlags.ResponseEnabled, (uint)SideFlags.Responds);
        flags |= Bit(collider, (uint)ColliderFlags.WantsContact, (uint)SideFlags.Heard);
        flags |= Bit(collider, (uint)ColliderFlags.WantsSeparation, (uint)SideFlags.Heard);
        flags |= Bit(~body, (uint)BodyFlags.Static, (uint)SideFlags.Turns);
        flags |= Bit(body, (uint)BodyFlags.Fast, (uint)SideFlags.Fast);
        return (SideFlags)flags;
    }

    /// <summary>One bit of some flags as another bit of others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Bit(uint flags, uint from, uint to) => to >= from ? (flags & from) * (to / from) : (flags & from) / (from / to);

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_sides);
        s.Column(_hulls);
        s.Value(ref _isKept);
        AnyHeard = s.Value(AnyHeard);
    }
}
