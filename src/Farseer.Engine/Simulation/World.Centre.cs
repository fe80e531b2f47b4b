using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Moves the centre of mass within a body, which is the origin of all that the engine keeps of it.</summary>
internal sealed partial class World
{
    /// <summary>
    /// The centre of mass moves by (<paramref name="x"/>, <paramref name="y"/>) in body axes; colliders and joints stay where they
    /// are in the world. The velocity is from now on that of the new centre: callers that want the body to go on turning as it
    /// did set it.
    /// </summary>
    public void MoveCentre(Handle body, double x, double y)
    {
        Require(body);
        ref BodyPose pose = ref Bodies.Pose[body.Index];
        pose.X += (pose.Cos * x) - (pose.Sin * y);
        pose.Y += (pose.Sin * x) + (pose.Cos * y);
        for (int collider = _firstCollider[body.Index]; collider >= 0; collider = _nextCollider[collider])
        {
            Shapes.MovePieces(collider, -x, -y);
        }

        for (int entry = Joints.First(body.Index); entry >= 0; entry = Joints.Next(entry))
        {
            ref JointSettings settings = ref Joints.Settings[entry >> 1];
            if ((entry & 1) == 0)
            {
                settings.AnchorAX -= x;
                settings.AnchorAY -= y;
            }
            else
            {
                settings.AnchorBX -= x;
                settings.AnchorBY -= y;
            }

            Joints.NoteEdit();
            _jointSolver?.Nets.Edited(entry >> 1, afresh: false);
        }

        NotePlaced(body.Index);
    }
}
