using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Where a joint is in the engine, and the bodies that it holds there.</summary>
internal sealed class JointAttachment
{
    private World? _world;

    /// <summary>True while the engine has the joint.</summary>
    public bool IsAttached => _world is not null;

    public int Index => Handle.Index;

    public float Error => FloatBits.Nearest(_world!.JointState(Handle).Error);

    public Vector2 ReactionForce
    {
        get
        {
            if (_world is null)
            {
                return Vector2.Zero;
            }

            ref JointState state = ref _world.JointState(Handle);
            return new Vector2(FloatBits.Nearest(state.ForceX), FloatBits.Nearest(state.ForceY));
        }
    }

    public float ReactionTorque => _world is null ? 0 : FloatBits.Nearest(_world.JointState(Handle).Torque);

    private Handle Handle { get; set; }

    public Body? First { get; private set; }

    public Body? Second { get; private set; }

    /// <summary>Notes the bodies of the joint as used by the simulator, and lets go of those that it had before.</summary>
    public void Hold(PhysicsSimulator simulator, Joint joint)
    {
        Body? first = joint.FirstBody;
        Body? second = joint.SecondBody;
        if (first is not null)
        {
            simulator.HoldBody(first);
        }

        if (second is not null)
        {
            simulator.HoldBody(second);
        }

        LetGo();
        joint.NoteSet();
        First = first;
        Second = second;
    }

    public void LetGo()
    {
        Body? first = First;
        Body? second = Second;
        First = null;
        Second = null;
        if (first is not null)
        {
            PhysicsSimulator.LetGo(first);
        }

        if (second is not null)
        {
            PhysicsSimulator.LetGo(second);
        }
    }

    /// <summary>Makes the joint in the engine; its bodies are in it already.</summary>
    public void Attach(World world, Joint joint)
    {
        joint.Describe(out JointSettings settings, out JointFlags flags);
        Handle a = First is null ? World.WorldFrame : First.Link.Handle;
        Handle = world.CreateJoint(joint.Kind!.Value, a, Second!.Link.Handle, settings, flags);
        _world = world;
    }

    /// <summary>Takes changed properties of the joint over.</summary>
    public void Push(Joint joint)
    {
        joint.Describe(out JointSettings settings, out JointFlags flags);
        _world!.SetJoint(Handle, settings, flags);
    }

    public void Detach(Joint joint)
    {
        joint.KeepError(Error);
        _world!.DestroyJoint(Handle);
        _world = null;
        Handle = default;
    }

    /// <summary>A world point in the frame of a body, in double precision.</summary>
    public static void ToLocal(Body body, Vector2 point, out double x, out double y) => ToLocal(body, point.X, point.Y, out x, out y);

    public static void ToLocal(Body body, double worldX, double worldY, out double x, out double y)
    {
        ref BodyPose pose = ref body.Link.PoseRef;
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        double dx = worldX - pose.X;
        double dy = worldY - pose.Y;
        x = (cos * dx) + (sin * dy);
        y = (cos * dy) - (sin * dx);
    }

    /// <summary>A direction of the world in the frame of a body, of length 1 in double precision.</summary>
    public static void ToLocalAxis(Body body, Vector2 axis, out double x, out double y)
    {
        StableMath.SinCos(body.Link.PoseRef.Angle, out double sin, out double cos);
        double length = System.Math.Sqrt(((double)axis.X * axis.X) + ((double)axis.Y * axis.Y));
        double ax = axis.X / length;
        double ay = axis.Y / length;
        x = (cos * ax) + (sin * ay);
        y = (cos * ay) - (sin * ax);
    }

    /// <summary>A point of a body in the world.</summary>
    public static void ToWorld(Body body, double x, double y, out double worldX, out double worldY)
    {
        ref BodyPose pose = ref body.Link.PoseRef;
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        worldX = pose.X + ((cos * x) - (sin * y));
        worldY = pose.Y + ((sin * x) + (cos * y));
    }

    public static Vector2 ToWorld(Body? body, Vector2 point)
    {
        if (body is null)
        {
            return point;
        }

        ToWorld(body, point.X, point.Y, out double x, out double y);
        return new Vector2((float)x, (float)y);
    }

    public static double Angle(Body? body) => body is null ? 0 : body.Link.PoseRef.Angle;

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Reference(ref _world);
        Handle = s.Value(Handle);
        First = s.Reference(First);
        Second = s.Reference(Second);
    }

    /// <summary>Lets go of a world that is about to be another one; the bodies are told by nobody.</summary>
    public void TakeOut(Joint joint)
    {
        if (_world is not null)
        {
            joint.KeepError(Error);
        }

        _world = null;
        Handle = default;
        First = null;
        Second = null;
    }
}
