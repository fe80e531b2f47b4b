using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>How a body moved since the narrow phase before, and how it goes on: 32 bytes, gathered by lanes.</summary>
[StructLayout(LayoutKind.Sequential, Size = 32)]
internal struct BodyStep
{
    /// <summary>Way of the centre of mass, and angle turned by without its sign.</summary>
    public float X;
    public float Y;
    public float Turn;
    public BodyStepFlags Flags;

    /// <summary>What the present velocity leads to within the step: way, and angle without its sign.</summary>
    public float AheadX;
    public float AheadY;
    public float AheadTurn;

    /// <summary>Set by whoever sees it, until the flags above are written from both.</summary>
    public ushort IsAltered;
    public ushort HasNewBox;
}

[Flags]
internal enum BodyStepFlags
{
    None = 0,

    /// <summary>What is known of the gaps around the body does not hold: something of it has changed.</summary>
    Altered = 1,

    /// <summary>Its fat boxes are new.</summary>
    NewBox = 2,

    /// <summary>Its pairs have wider margins.</summary>
    Fast = 4,
    Asleep = 8,
}

/// <summary>
/// The motions of all bodies from one narrow phase to the next, from which <see cref="IdleGap"/> knows which pairs cannot have come near.
/// From poses, so that it does not matter what moved a body.
/// </summary>
internal sealed unsafe class BodySteps
{
    /// <summary>Passes over bodies that have just fallen asleep: one sees their last motion, the next that there is none.</summary>
    private const byte LastPasses = 2;

    private readonly Column<BodyStep> _steps = new Column<BodyStep>();
    private readonly Column<Place> _places = new Column<Place>();
    private readonly Column<byte> _left = new Column<byte>();

    // Bodies of which motions were found: not how much room there happens to be.
    private int _end;

    public BodyStep* Pointer => _steps.Pointer;

    /// <summary>Makes room for so many bodies.</summary>
    /// <returns>Words of as many bits as they fill.</returns>
    public int Reserve(int end)
    {
        int words = (end + BitSet.WordBits - 1) / BitSet.WordBits;
        _steps.EnsureCapacity(words * BitSet.WordBits);
        _places.EnsureCapacity(words * BitSet.WordBits);
        _left.EnsureCapacity(words);
        return words;
    }

    /// <summary>Begins with so many bodies. After a time without passes all are looked at.</summary>
    public void Begin(int end, bool afresh)
    {
        int words = Reserve(end);
        _end = words * BitSet.WordBits;
        for (int word = 0; afresh && word < words; word++)
        {
            _left[word] = LastPasses;
        }
    }

    /// <summary>A body was put elsewhere or its pieces were changed.</summary>
    public void Alter(int body)
    {
        if (body < _end)
        {
            _steps[body].IsAltered = 1;
        }
    }

    /// <summary>Finds the motions of the bodies of some words, but for those that sleep on.</summary>
    public void Find(BodyStore bodies, float dt, int firstWord, int endWord)
    {
        ulong* visited = bodies.Visited.Words;
        byte* left = _left.Pointer;
        for (int word = firstWord; word < endWord; word++)
        {
            if (visited[word] != 0)
            {
                left[word] = LastPasses;
            }
            else if (left[word] == 0)
            {
                continue;
            }
            else
            {
                left[word]--;
            }

            Find(bodies, dt, word);
        }
    }

    private void Find(BodyStore bodies, float dt, int word)
    {
        BodyPose* poses = bodies.Pose.Pointer;
        BodyState* states = bodies.State.Pointer;
        BodyFlags* flags = bodies.Flags.Pointer;
        Place* places = _places.Pointer;
        BodyStep* steps = _steps.Pointer;
        int end = Math.Min((word + 1) * BitSet.WordBits, bodies.Ids.End);
        for (int i = word * BitSet.WordBits; i < end; i++)
        {
            BodyStep* step = steps + i;
            Place* place = places + i;
            BodyPose* pose = poses + i;
            BodyState* state = states + i;
            step->X = (float)(pose->X - place->X);
            step->Y = (float)(pose->Y - place->Y);
            step->Turn = (float)Math.Abs(pose->Angle - place->Angle);
            place->X = pose->X;
            place->Y = pose->Y;
            place->Angle = pose->Angle;
            step->AheadX = state->LinearVelocity.X * dt;
            step->AheadY = state->LinearVelocity.Y * dt;
            step->AheadTurn = Math.Abs(state->AngularVelocity) * dt;
            step->Flags = (step->IsAltered != 0 ? BodyStepFlags.Altered : BodyStepFlags.None)
                | (step->HasNewBox != 0 ? BodyStepFlags.NewBox : BodyStepFlags.None)
                | ((flags[i] & BodyFlags.Fast) != 0 ? BodyStepFlags.Fast : BodyStepFlags.None)
                | ((flags[i] & BodyFlags.Asleep) != 0 ? BodyStepFlags.Asleep : BodyStepFlags.None);
            step->IsAltered = 0;
            step->HasNewBox = 0;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct Place
    {
        public double X;
        public double Y;
        public double Angle;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_steps);
        s.Column(_places);
        s.Column(_left);
        s.Value(ref _end);
    }
}
